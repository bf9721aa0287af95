#pragma once
#include <memory>
#include <vector>

#include "app/deck/deck.hpp"
#include "core/materials/material.hpp"

namespace brunt {

/// The laws of a deck's materials. `adiabatic`: plastic work heats the point.
std::vector<std::unique_ptr<Material>> make_materials(const Deck& deck);

/// The material of a body among those that make_materials made; null where it names none.
const Material* material_of(const Deck& deck,
                            const std::vector<std::unique_ptr<Material>>& materials,
                            const deck::Body& body);

}  // namespace brunt
