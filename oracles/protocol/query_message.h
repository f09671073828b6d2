#pragma once

#include <span>
#include <vector>

#include "oracles/protocol/message.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** Returns a body as an object with the keys of a scenario file: "shape" and its sizes,
 "position", "rotation" (three rows) and "quaternion" (w, x, y, z). */
Json ToJson(const Body& body);

/** Returns the body in `json`. Its rotation is that of the question, bit for bit.
 @throws ProtocolError */
Body BodyFrom(const Received& json);

/** Adds `queries` to `message`, as "queries", or in the frame if `in_frame`.

 A frame holds for each body, A then B: kind (its number in the order of ShapeKind),
 position (3), rotation (9, row by row), quaternion (4, w first), the number n of sizes,
 and n sizes. The sizes are those of the shape in the order of its members, and of a hull
 the coordinates of its vertices. */
void PutQueries(std::span<const ContactQuery> queries, bool in_frame, Message& message);

/** Returns the queries that PutQueries() has put. @throws ProtocolError */
std::vector<ContactQuery> QueriesFrom(const Message& message);

}  // namespace touchstone
