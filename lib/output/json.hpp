#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace plumb {

/// `value` with every non-finite number replaced by null. The object that holds such a number, directly or in
/// an array, says so: it gets "status": "not finite: rmse (nan), lo[2] (inf)"; where it has a status of its
/// own, that stays and the text goes to "not_finite".
nlohmann::ordered_json with_finite_numbers(nlohmann::ordered_json value);

/// UTF-8 JSON text, indented by 1, ending in a newline. Numbers are the shortest text that reads back to the
/// same double (at most 17 significant digits). Non-finite numbers are treated as in with_finite_numbers.
std::string json_text(const nlohmann::ordered_json& value);

}  // namespace plumb
