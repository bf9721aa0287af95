#pragma once
#include <string>
#include <vector>

#include "core/parallel/communicator.hpp"
#include "core/view.hpp"

namespace brunt {

/// One place whose fields stand in every row of history.csv.
struct Probe {
  std::string name;
  Label body = 0;
  std::vector<std::string> fields;             ///< "stress.xx"
  std::vector<char> of_cell;                   ///< by field: it lives in elements
  std::vector<GlobalId> points;                ///< ids of those that point fields come from
  std::vector<Real> weights;                   ///< [1] of them, of time 0
  std::vector<unsigned> reflected;             ///< by point: as in Place
  GlobalId cell = 0;                           ///< id of the element that cell fields come from
  Real point_distance = 0, cell_distance = 0;  ///< [m] outside of the body: as in Place
};

/// Where it is, for the log.
std::string place_text(const Probe& probe);
/// The column of a field.
std::string column_of(const Probe& probe, std::size_t field);

/// What `probe_values` reads of the probe's body.
WantedFields fields_of(const Probe& probe);
/// Values of a probe's fields from what each rank has of its body; NaN where its element is gone.
/// Collective.
std::vector<Real> probe_values(const Probe& probe, const BodyView& mine, const Communicator& ranks);

}  // namespace brunt
