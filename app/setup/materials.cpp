#include "app/setup/materials.hpp"

#include "core/materials/catalog.hpp"

namespace brunt {

std::vector<std::unique_ptr<Material>> make_materials(const Deck& deck) {
  std::vector<std::unique_ptr<Material>> materials;
  for (const auto& [name, given] : deck.materials) {
    auto material = std::make_unique<Material>();
    material->name = name;
    material->density = given.density;
    material->shear = given.shear_modulus();
    material->tensile_cutoff = given.tensile_cutoff.value_or(kInfinity);
    material->thermal = given.thermal.has_value();
    StrengthInputs strength;
    strength.shear = material->shear;
    strength.tensile_cutoff = material->tensile_cutoff;
    if (given.thermal) {
      material->specific_heat = SpecificHeat(*given.thermal->cp);
      if (given.thermal->k) material->conductivity = *given.thermal->k;
      material->expansion = given.thermal->expansion;
      const SpecificHeat& cp = material->specific_heat;
      strength.heat_capacity = given.density * cp.least();
      if (cp.varies()) strength.specific_heat = &cp, strength.density = given.density;
      strength.taylor_quinney = given.thermal->taylor_quinney;
    }
    material->strength = make_strength(given.melting_strength(), strength);
    material->eos = make_eos(given.eos, EosInputs{given.density, given.bulk_modulus()});
    material->bulk = material->eos->bulk_modulus();
    material->damage = make_damage(given.melting_damage(), {material->shear});
    materials.push_back(std::move(material));
  }
  return materials;
}

const Material* material_of(const Deck& deck,
                            const std::vector<std::unique_ptr<Material>>& materials,
                            const deck::Body& body) {
  for (std::size_t m = 0; m < deck.materials.size(); ++m) {
    if (deck.materials[m].name == body.material) return materials[m].get();
  }
  return nullptr;
}

}  // namespace brunt
