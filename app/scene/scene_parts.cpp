#include "app/scene/scene.hpp"

namespace brunt {

namespace {
const WantedFields kPieces{{{"piece"}}};

/// The view of a part, from views of its body that have the fields asked for, or the whole.
template <class ViewOf>
BodyView view_of_part(const std::optional<BodyPart>& part, const WantedFields& wanted,
                      const ViewOf& view_of) {
  if (!part) return {};
  BodyView view = view_of(part->body, wanted);
  if (part->piece) keep_piece(*part->piece, view_of(part->body, kPieces), view);
  return view;
}
}  // namespace

template <int Dim>
BodyView Scene<Dim>::own_part_view(const std::string& name, const WantedFields& wanted) const {
  return view_of_part(part_named(body_names, pieces, name), wanted,
                      [this](Label body, const auto& fields) { return own_view(body, fields); });
}

template <int Dim>
BodyView Scene<Dim>::part_view(const std::string& name, const WantedFields& wanted) const {
  return view_of_part(part_named(body_names, pieces, name), wanted,
                      [this](Label body, const auto& fields) { return view(body, fields); });
}

template BodyView Scene<2>::part_view(const std::string&, const WantedFields&) const;
template BodyView Scene<2>::own_part_view(const std::string&, const WantedFields&) const;
template BodyView Scene<3>::part_view(const std::string&, const WantedFields&) const;
template BodyView Scene<3>::own_part_view(const std::string&, const WantedFields&) const;

}  // namespace brunt
