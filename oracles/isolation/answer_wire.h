#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "oracles/contact_answer.h"
#include "oracles/trajectory.h"

namespace touchstone {

/** Returns `answer` as bytes for another process of the same program on the same machine.
 Every double is kept bit for bit. The format, in the machine's byte order:

     u8 version, u8 status, u8 flags, u32 length + reason,
     [3 doubles n_AB_W] [double separation] [6 doubles witnesses],
     u32 count + points, each:
         3 doubles p_WC, double separation, u8 flag, [3 doubles n_AB_W]

 A field in brackets is present if its flag is set. */
std::string ToWire(const ContactAnswer& answer);

/** Returns the answer encoded in `bytes`, or nothing if they are not a valid encoding:
 the sender may have corrupted its memory. Whatever the bytes contain, this function reads
 none beyond them and allocates at most a small multiple of their number. */
std::optional<ContactAnswer> FromWire(std::string_view bytes);

/** Returns `trajectory` as bytes, in the same way:

     u8 version, u8 status, u8 flags, u32 length + reason, u32 length + complaint,
     u32 diverged_at_step, u64 counts of bodies, particles, nodes (of every sample),
     u64 count + samples, each a double time, 13 doubles per body and 6 per point,
     u64 count + impulses, each u32 step, A, B and 10 doubles

 @pre Every sample has as many bodies, particles and nodes as the first. */
std::string ToWire(const Trajectory& trajectory);

/** Returns the trajectory encoded in `bytes`, with the same safety as FromWire(). */
std::optional<Trajectory> TrajectoryFromWire(std::string_view bytes);

}  // namespace touchstone
