// The benchmark table, as Markdown and as JSON.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "rows.h"

namespace glare::bench {

/// The rows that were measured as a Markdown table, what | measured | reach | stretch, and below it
/// how they came about.
std::string markdown(const std::vector<std::unique_ptr<Row>>& rows);

/// The rows that were measured as a JSON list of {what, value, unit, reach, stretch, at_least};
/// reach and stretch are numbers, or null where there is none.
std::string json(const std::vector<std::unique_ptr<Row>>& rows);

}  // namespace glare::bench
