#include <algorithm>

#include "pushback/chapters/04_slop/scenes.h"
#include "pushback/chapters/04_slop/slop.h"
#include "pushback/common/experiment/experiment.h"
#include "pushback/common/render/palette.h"

using namespace pushback;
using namespace pushback::slop_scenes;

namespace {

/// Marks the contact points that the step before already had. (Chapter 07 will have a better use for them.)
struct MarkOld : Effect {
  std::vector<ContactId> before;
  void report(StepContext& step) {
    std::vector<ContactId> now;
    for (Contact& contact : step.contacts) {
      const bool old = std::binary_search(before.begin(), before.end(), contact.id);
      contact.state = old ? ContactState::warm : ContactState::fresh;
      now.push_back(contact.id);
    }
    before = std::move(now);
  }
};

/// The column of the raster that a world makes: the points with which the pile starts, those of the lowest box at the foot.
/// Above those of each box is a cell for any other point at its lower face.
struct PointsOfPile {
  enum Cell { kept, fresh, missing };
  std::vector<ContactId> points;

  explicit PointsOfPile(const SmallPile& pile) {
    World world;
    pile(world);
    world.find_contacts();
    for (const Contact& contact : world.contacts) points.push_back(contact.id);
  }

  std::vector<int> operator()(const World& world) const {
    constexpr std::size_t boxes = 3;
    std::vector<int> column(points.size() + boxes, missing);
    for (std::size_t i = 0, box = 0; box < boxes; ++box) {
      while (i < points.size() && points[i].body_a == box) ++i;
      column[column.size() - 1 - i - box] = -1;  // another point is not missed
    }
    for (const Contact& contact : world.contacts) {
      const std::size_t below = contact.id.body_a;  // the ground is 0, and the boxes are counted from there
      auto at = std::lower_bound(points.begin(), points.end(), contact.id);
      if (at == points.end() || *at != contact.id)
        at = std::find_if(at, points.end(), [&](const ContactId& id) { return id.body_a > below; });
      column[column.size() - 1 - static_cast<std::size_t>(at - points.begin()) - below] =
          contact.state == ContactState::warm ? kept : fresh;
    }
    return column;
  }
};

Real found_and_lost_each_second(const Run& run) {
  Real changes = 0;
  const std::vector<Sample> last = run.last(2);
  for (const Sample& sample : last) changes += static_cast<Real>(sample.found + sample.lost);
  return changes / (static_cast<Real>(last.size()) * run.dt);
}

/// Of all impulses of the step before, the part that acted at points which are missing now, %. Chapter 07 starts from them.
Real lost_with_its_point(const World& world) {
  Real all = 0, lost = 0;
  for (const Contact& before : world.contacts_before) {
    const bool kept = std::any_of(world.contacts.begin(), world.contacts.end(),
                                  [&](const Contact& contact) { return contact.id == before.id; });
    const Real impulse = before.impulse.norm();
    all += impulse;
    if (!kept) lost += impulse;
  }
  return all > 0 ? 100 * lost / all : 0;
}

/// Mean overlap of the last second, mm.
Real resting_depth(const Run& run) {
  Real sum = 0;
  const std::vector<Sample> last = run.last(1);
  for (const Sample& sample : last) sum += sample.overlap;
  return 1000 * sum / static_cast<Real>(last.size());
}

}  // namespace

int main(int argc, char** argv) {
  Experiment e("04_slop", "Why leave a little overlap alone?");
  std::vector<Real> slops{0, Real(0.005), Real(0.02)};
  e.parameter({"--slop", "slop", "m", "Overlaps to leave alone", 0, 0.1}, &slops);
  Real beta = Baumgarte{}.beta;
  e.parameter({"--beta", "β", "", "Fraction of the excess overlap removed per step", 0, 1}, &beta);
  SmallPile pile;
  e.parameter({"--depth", "", "m", "Overlap of each box at the start", 0, 0.05}, &pile.depth);
  return e.run(argc, argv, [&] {
    e.scene({.name = "three boxes at rest",
             .fill = pile,
             .camera = {{Real(2), Real(1.9), Real(3.6)}, {0, Real(0.8), 0}, Real(0.54)},
             .seconds = 4,
             .instants = {Real(3.2)},
             .caption =
                 "The boxes start 8 mm deep in each other. Each bar of the strip is one contact point, from step to "
                 "step. Without slop the bars are torn, because points are lost and detected again, and the remaining "
                 "points take over their load. With slop every point stays.",
             .start_shown = false,
             .raster = Raster{.label = "a bar per contact point, the lowest box at the bottom",
                              .of = PointsOfPile(pile),
                              .meaning = {{{170, 190, 214}, "as in the step before"},
                                          {body_ink(3), "new"},
                                          {near_black_ink(), "missing"}}}});
    for (const Real slop : slops) {
      Solver<Clamping, Baumgarte, Slop, MarkOld> solver;
      solver.slop = slop;
      solver.beta = beta;
      e.variant(fmt::format("slop = {:.3g} mm", 1000 * slop), solver).with_sweeps(40);
    }
    e.series("deepest overlap", "mm", [](const World& world) { return 1000 * deepest_overlap(world); });
    e.series("impulse lost with its point", "%", lost_with_its_point);
    e.number("points found or lost", "each second", found_and_lost_each_second);
    e.number("impulse lost in one step, at worst", "%", [](const Run& run) {
      const auto& lost = run.series.at("impulse lost with its point");
      return *std::max_element(lost.begin(), lost.end());
    });
    e.number("resting depth", "mm", resting_depth);
  });
}
