#include "pushback/chapters/11_substeps/study.h"
#include "pushback/chapters/21_detected_once/detected_once.h"
#include "pushback/chapters/22_wide/scenes.h"
#include "pushback/chapters/22_wide/study.h"
#include "pushback/common/experiment/marks.h"
#include "pushback/common/render/palette.h"

using namespace pushback;
using namespace pushback::substeps_scenes;
using namespace pushback::wide_scenes;

namespace {

Ink ink_of_set(std::size_t set) {
  const std::array inks{normal_arrow_ink(),
                        contact_ink(ContactState::warm),
                        friction_arrow_ink(),
                        contact_ink(ContactState::sticking),
                        contact_ink(ContactState::fresh),
                        contact_ink(ContactState::sliding)};
  return inks[set % inks.size()];
}

/// Draws lines, in front of boxes of 1 m, from the middle of each body of a pair to their contact.
void draw_sets(Picture& picture, const World& world, Real /*time*/) {
  const PairSets sets = sets_in(world);
  for (std::size_t set = 0; set < sets.size(); ++set) {
    for (const TouchingPair& pair : sets[set]) {
      Vec3 touch = Vec3::Zero();
      for (std::size_t i = 0; i < pair.count; ++i)
        touch += world.contacts[pair.first + i].point / static_cast<Real>(pair.count);
      touch.z() = Real(0.55);
      for (const std::size_t body : {pair.a, pair.b}) {
        if (!world.bodies[body].movable()) continue;
        const Vec3& middle = world.bodies[body].position;
        add_line(picture, {{middle.x(), middle.y(), touch.z()}, touch}, linear(ink_of_set(set)), 6);
      }
    }
  }
}

void number_sets(Experiment& e) {
  e.number("sets", "", [](const Run& run) { return static_cast<Real>(sets_in(run.world).size()); });
  e.number("lanes with a contact", "%", [](const Run& run) { return 100 * part_filled(sets_in(run.world)); });
}

}  // namespace

int main(int argc, char** argv) {
  Experiment e("22_wide", "What can be solved side by side?");
  int substeps = DetectedOnce{}.substeps;
  e.parameter({"--substeps", "", "", "Substeps per step", 1, 128}, &substeps);
  int base = 10;
  e.parameter({"--base", "n", "", "Boxes in the pyramid's lowest row", 1, 20}, &base);
  int tall = 40;
  e.parameter({"--boxes", "n", "", "Boxes in the stack", 2, 40}, &tall);
  LoadedSlab slab;
  e.parameter({"--square", "n", "", "Boxes along each side of the slab", 1, 12}, &slab.boxes);
  HeavyOnLight heavy;
  e.parameter({"--mass-ratio", "", "", "Mass ratio of the upper and lower box", 1, 2000}, &heavy.mass_ratio);
  return e.run(argc, argv, [&] {
    DetectedOnce once;
    WideSolver<double> doubles;
    WideSolver<float> floats;
    once.substeps = doubles.substeps = floats.substeps = substeps;
    const auto in_three_ways = [&] {
      e.variant("chapter 21", once).with_exactly(1).coloured(0).without_curves();
      e.variant("wide, double", doubles).with_exactly(1).coloured(2).without_curves();
      e.variant("wide, float", floats).with_exactly(1).coloured(1).without_curves();
    };
    const auto fill_pyramid = [base](World& world) {
      pyramid(world, base);
      for (Body& body : world.bodies)
        if (body.movable()) body.coloured(1);
    };

    e.scene({.name = "a pyramid, and its pairs",
             .fill = fill_pyramid,
             .camera = {{0, Real(0.47) * static_cast<Real>(base), 3 * static_cast<Real>(base)},
                        {0, Real(0.47) * static_cast<Real>(base), 0},
                        Real(0.36)},
             .seconds = 1,
             .contacts = Drawn::nothing,
             .caption = "Each line is a pair of bodies that touch. Pairs of one colour never meet in a box: they are "
                        "solved side by side.",
             .colours = {{ink_of_set(0), "first set"},
                         {ink_of_set(1), "second"},
                         {ink_of_set(2), "third"},
                         {ink_of_set(3), "fourth"}},
             .start_shown = false,
             .marks = draw_sets,
             .strobe = Strobe{.every = 1, .shift_per_second = {0, 0, 0}, .from = 1, .height = 700}});
    e.variant("wide, float", floats).with_exactly(1).coloured(1).without_curves();
    number_sets(e);

    e.scene({.name = "the pyramid in three ways", .fill = fill_pyramid, .seconds = 10, .pictures = false});
    e.series_without_curves("largest speed", [](const World& world) { return 1000 * largest_speed(world); });
    e.number("speed at the end", "mm/s", [](const Run& run) { return run.series.at("largest speed").back(); });
    number_overlap(e);
    in_three_ways();

    e.scene({.name = "a stack of " + spelled(tall) + " in four orders",
             .fill = [tall](World& world) { stack(world, tall); },
             .seconds = 10,
             .pictures = false});
    watch_stack(e);
    const auto in_order = [&](const char* name, auto order) -> Variant& {
      WideSolver<double> solver = doubles;
      solver.make_sets = order;
      return e.variant(name, solver).with_exactly(1);
    };
    in_order("from the ground up", one_by_one).coloured(0).without_curves();
    in_order("from the top down", from_the_last).coloured(3).without_curves();
    in_order("shuffled", shuffled).coloured(4).without_curves();
    in_order("by colours", colour_pairs).coloured(2).without_curves();

    scene_of_heavy(e, heavy);
    in_three_ways();

    e.scene({.name = "a slab under many boxes", .fill = slab, .seconds = 1, .pictures = false});
    e.variant("wide, float", floats).with_exactly(1).coloured(1).without_curves();
    number_sets(e);
  });
}
