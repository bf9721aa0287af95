/// Measures of a monitor: what they remember of time 0, and when which is taken.
#include <limits>
#include <stdexcept>

#include "app/watch/monitor.hpp"

namespace brunt {

/// Keeps of time 0 what measures read of it.
template <int Dim>
void Monitor<Dim>::keep_start(Scene<Dim>& scene) {
  std::map<std::string, WantedFields> wanted;
  for (const auto& [name, measure] : deck_.measures) {
    const auto reads = reads_of(measure);
    if (!reads || !reads->at_start) continue;
    auto& names = wanted.try_emplace(reads->body, kNoFields).first->second.names;
    names->insert(names->end(), reads->fields.names->begin(), reads->fields.names->end());
  }
  for (const auto& [name, fields] : wanted) {
    real_.make_real(start_[name] = scene.part_view(name, fields));
  }
}

/// One measure, on the root, at a real time [s]. What cannot be measured has no number, and says
/// why.
template <int Dim>
MeasureValue Monitor<Dim>::measured(const Named<deck::Measure>& entry, const MeasureSource& source,
                                    Real time) {
  const auto& [name, measure] = entry;
  MeasureValue taken{name,
                     std::numeric_limits<Real>::quiet_NaN(),
                     deck::shown_unit_of(measure),
                     measure.reference,
                     measure.exact,
                     time};
  try {
    taken.value = evaluate_measure(measure, source, measures_);
  } catch (const std::exception& error) {
    warnings_.push_back("'" + name + "' has no value: " + error.what());
    warn({kMeasureWarning, warnings_.back()});
  }
  return taken;
}

template <int Dim>
void Monitor<Dim>::take_measures(Scene<Dim>& scene, const Clock& clock, bool at_end) {
  const auto is_due = [&](std::size_t i) {
    const auto& measure = deck_.measures[i].value;
    return !measured_[i] && (measure.at ? clock.time() >= *measure.at : at_end);
  };
  bool any_due = false;
  for (std::size_t i = 0; i < deck_.measures.size(); ++i) any_due = any_due || is_due(i);
  if (!any_due) return;
  BodyView view;  // of one measure at a time; all ranks take part, the root evaluates
  const MeasureSource source{[&](const std::string& body) -> const BodyView& {
                               if (!part_named(scene.body_names, scene.pieces, body)) {
                                 throw std::invalid_argument("there is no body '" + body + "'");
                               }
                               return view;
                             },
                             &start_, &columns_, &rows_};
  for (std::size_t i = 0; i < deck_.measures.size(); ++i) {
    const auto& entry = deck_.measures[i];
    if (!is_due(i)) continue;
    measured_[i] = true;
    const auto reads = reads_of(entry.value);
    view = reads ? scene.part_view(reads->body, reads->fields) : BodyView{};
    real_.make_real(view);
    if (!scene.ranks->is_root()) continue;
    measures_.push_back(measured(entry, source, clock.real_time()));
  }
}

template void Monitor<2>::keep_start(Scene<2>&);
template void Monitor<3>::keep_start(Scene<3>&);
template void Monitor<2>::take_measures(Scene<2>&, const Clock&, bool);
template void Monitor<3>::take_measures(Scene<3>&, const Clock&, bool);

}  // namespace brunt
