#pragma once

#include <cstddef>

#include "oracles/protocol/message.h"
#include "oracles/trajectory.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** Adds `trajectory` to `message`: "times", "samples" and, if the engine gives them,
 "impulses"; or in a frame if `in_frame`.

 A sample is one list of numbers: for each body position (3), orientation (4, w first),
 velocity (3) and spin (3), then for each particle and each node of a cloth position (3)
 and velocity (3). An impulse is a list of its step, A, B, point (3), normal (3), impulse
 on B (3), separation, and the direction of friction (3, zero if there is none). A frame
 holds for each sample its time and its numbers, then the impulses; the line says how many
 there are of each, "sample_count" and "impulse_count". */
void PutTrajectory(const Trajectory& trajectory, bool in_frame, Message& message);

/** Returns the motion of `world` that `message` holds. It ends before the first sample
 with a number that is not finite or beyond kMostReached, and states that step as the one
 of its divergence, unless the message states one.
 @throws ProtocolError if the message has other samples than the world. */
Trajectory TrajectoryFrom(const Message& message, const World& world);

/** Returns the longest line or frame that is accepted as the motion of `world`: room for
 its samples and for a few contact impulses in each step, at most 4 GiB. [bytes] */
std::size_t MostBytesOf(const World& world);

}  // namespace touchstone
