// A question of the interface, and its known answer with the proof, as JSON objects.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "verify/exact/timing_query.hpp"
#include "verify/operations/catalogue.hpp"

namespace tps::vectors {

using Json = nlohmann::ordered_json;
using operations::Op;

/// A double as files spell it: a hexadecimal float, or "inf".
Json hex(double x);
Json hex(const std::vector<double>& x);
/// Three digits, since a condition number is a size; null where it is absent or infinite.
Json rounded_condition(const std::optional<double>& condition);

double read_number(const Json& value);
std::vector<double> read_vector(const Json& value);

/// The "in" of block_time, tether_time and wall_time, and back. A query of the plane is written with 2
/// components.
Json timing_input(const exact::TimingQuery& query, int dimension);
exact::TimingQuery read_timing_input(exact::Kind kind, const Json& in);

/// The fields of a case that follow from its operation and its "in": the answer, its proof, its condition
/// number. `in` is read as `tps serve` reads it. Throws InputError where the operation does not take it,
/// std::invalid_argument for an operation without known answers and for a question without a single one.
Json known_answer(operations::Op op, const Json& in);

/// The tolerance classes that a known answer of an operation accepts (docs/vectors.md, "Who passes").
Json accepted_by(operations::Op op);

}  // namespace tps::vectors
