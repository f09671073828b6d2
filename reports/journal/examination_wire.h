#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "reports/worlds/study/examine_world.h"

namespace touchstone {

/** Returns `examination` as bytes for a later run of the same program on the same
 machine. Every double is kept bit for bit. The format, in the machine's byte order, is
 that of WireWriter (oracles/isolation/wire.h): the trajectory as ToWire() writes it
 (oracles/isolation/answer_wire.h), preceded by its length; 4 doubles of drifts; i32
 members and 6 doubles of statistics; u32 count + findings, field by field. */
std::string ToWire(const Examination& examination);

/** Returns the examination encoded in `bytes`, or nothing if they are not a valid
 encoding. Whatever they contain, it reads none beyond them. */
std::optional<Examination> ExaminationFromWire(std::string_view bytes);

}  // namespace touchstone
