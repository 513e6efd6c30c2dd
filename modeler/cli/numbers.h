// numbers.h — numbers as a person types them on a command line or a ray file: "1,2.5,-3e2".
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace whittle {

// The number that is the whole of `text` (blanks around it and a leading + allowed); none if it is anything else, or not finite.
std::optional<double> number_in(std::string_view text);

// Numbers between commas; none if any is not a number.
std::optional<std::vector<double>> numbers_in(std::string_view text);

// Reads one number at the front of `text` and drops it, with the blanks and commas before it. The direct way for many rays.
bool take_number(std::string_view& text, double& number);

}  // namespace whittle
