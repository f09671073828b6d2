#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "oracles/contact_answer.h"
#include "oracles/trajectory.h"

namespace touchstone {

/** Returns `answer` as bytes for another process of the same program on the same machine,
 every double bit for bit:

     u8 version, u8 status, u8 flags, u32 length + reason,
     [3 doubles n_AB_W] [double separation] [6 doubles witnesses],
     u32 count + points, each 3 doubles p_WC, double separation, u8 flag [3 doubles
 n_AB_W]

 in the machine's byte order; what is in brackets is there where a flag says so. */
std::string ToWire(const ContactAnswer& answer);

/** Returns the answer that `bytes` are the wire form of, or nothing where they are not
 one: the sender may have gone mad. Reads no byte beyond them and allocates no more than a
 small multiple of their number, whatever they say. */
std::optional<ContactAnswer> FromWire(std::string_view bytes);

/** Returns `trajectory` likewise:

     u8 version, u8 status, u8 flags, u32 length + reason, u32 length + complaint,
     u32 diverged_at_step, u64 counts of bodies, particles, nodes (of every sample),
     u64 count + samples, each a double time, 13 doubles a body and 6 a point,
     u64 count + impulses, each u32 step, A, B and 10 doubles

 @pre Every sample has as many bodies, particles and nodes as the first. */
std::string ToWire(const Trajectory& trajectory);

/** Returns the trajectory that `bytes` are the wire form of, with the caution of
 FromWire(). */
std::optional<Trajectory> TrajectoryFromWire(std::string_view bytes);

}  // namespace touchstone
