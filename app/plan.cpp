#include <omp.h>
#include <sys/resource.h>

#include <cmath>
#include <cstdio>

#include "app/build/materials.hpp"
#include "app/build/scene_builder.hpp"
#include "app/build/sound_part.hpp"
#include "app/run.hpp"

namespace brunt {

namespace {
template <int Dim>
void print_bodies(const LoadedDeck& loaded, const Scene<Dim>& scene) {
  for (std::size_t b = 0; b < scene.body_names.size(); ++b) {
    const auto& body = loaded.deck.bodies[b].value;
    std::size_t points = 0, elements = 0;
    for (const auto& solid : scene.solids) {
      for (const Label label : solid->points().body) points += label == b;
    }
    const BodyView view = scene.view(static_cast<Label>(b));
    if (view.corners > 0)
      elements = view.connectivity.size() / static_cast<std::size_t>(view.corners);
    if (body.rigid) {
      std::printf("  %-16s rigid, %s: %zu facets; updates no elements\n",
                  scene.body_names[b].c_str(), body.motion ? "moves as told" : "held", elements);
    } else if (body.method == deck::Method::fe) {
      std::printf("  %-16s finite elements: %zu elements, %zu nodes, material %s\n",
                  scene.body_names[b].c_str(), elements, points, body.material.c_str());
    } else {
      std::printf("  %-16s SPH: %zu particles, material %s\n", scene.body_names[b].c_str(), points,
                  body.material.c_str());
    }
  }
}

void print_physics(const LoadedDeck& loaded) {
  bool heated = false;
  for (const auto& material : loaded.deck.materials) {
    heated = heated || is_adiabatic(loaded.deck, material.value);
  }
  std::printf("heat       %s\n", heated ? "adiabatic: plastic work heats the point where it is done"
                                        : "none: no material is heated, no temperature is kept");
  if (!loaded.deck.gravity.empty()) std::printf("gravity    yes\n");
  if (loaded.deck.damping) std::printf("damping    %g 1/s\n", loaded.deck.damping->rate);
}

template <int Dim>
void print_plan(const LoadedDeck& loaded) {
  auto scene = build_scene<Dim>(loaded);
  static constexpr const char* geometries[] = {"3d", "plane strain", "axisymmetric"};
  std::printf("%s\n", loaded.deck.title.c_str());
  std::printf("geometry   %s\n", geometries[static_cast<int>(scene->geometry)]);
  print_bodies(loaded, *scene);
  print_physics(loaded);
  if (scene->contact) {
    std::printf("contact    %zu facets", scene->contact->n_facets());
    for (const auto& pair : scene->contact->reports()) std::printf(", %s", pair.name.c_str());
    std::printf("\n");
  } else {
    std::printf("contact    none: nothing can touch\n");
  }
  scene->supports.start();
  scene->rearrange();
  const StepVote vote = scene->stable_step(0, 0);
  const Real dt =
      std::min(loaded.deck.time.safety * vote.step, loaded.deck.time.max_step.value_or(kInfinity));
  std::printf("points     %zu (%zu elements, %zu particles)\n", scene->n_points(),
              scene->n_elements(), scene->n_particles());
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("memory     %.0f MB now, with all lists\n",
              static_cast<double>(usage.ru_maxrss) / 1024);
  std::printf("step       %.4g s, bound by %s of %s\n", dt, vote.reason,
              scene->body_names[vote.body].c_str());
  std::printf("steps      about %.0f to %g s, more where elements flatten\n",
              std::ceil(loaded.deck.time.end / dt), loaded.deck.time.end);
}

}  // namespace

int plan_command(const RunArguments& arguments) {
  const LoadedDeck loaded = load_or_tell_all(arguments.deck, arguments.overrides);
  if (loaded.deck.geometry == Geometry::three_d) {
    print_plan<3>(loaded);
  } else {
    print_plan<2>(loaded);
  }
  return kDone;
}

int check_command(const RunArguments& arguments) {
  const LoadedDeck loaded = load_or_tell_all(arguments.deck, arguments.overrides);
  if (loaded.deck.geometry == Geometry::three_d) {
    build_scene<3>(loaded);
  } else {
    build_scene<2>(loaded);
  }
  std::printf("%s: right\n", arguments.deck.c_str());
  return kDone;
}

}  // namespace brunt
