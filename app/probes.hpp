#pragma once
#include <string>
#include <vector>

#include "core/parallel/communicator.hpp"
#include "core/view.hpp"

namespace brunt {

/// One point or element whose fields stand in every row of history.csv.
struct Probe {
  std::string name;
  Label body = 0;
  std::vector<std::string> fields;             ///< "stress.xx"
  std::vector<char> of_cell;                   ///< by field: it lives in elements
  GlobalId point = 0, cell = 0;                ///< ids of what is nearest at time 0
  Real point_distance = 0, cell_distance = 0;  ///< [m] of them at time 0
};

/// Where it is, for the log.
std::string place_text(const Probe& probe);
/// The column of a field.
std::string column_of(const Probe& probe, std::size_t field);

/// Values of a probe's fields from what each rank has of its body; NaN where its element is gone.
/// Collective.
std::vector<Real> probe_values(const Probe& probe, const BodyView& mine, const Communicator& ranks);

}  // namespace brunt
