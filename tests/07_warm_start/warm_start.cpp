/// What chapter 07's page says of its scenes, over a minute and from many starts.
#include "pushback/chapters/07_warm_start/full_solver.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <sstream>

#include "pushback/common/world/measure.h"
#include "pushback/common/world/situations.h"
#include "tests/support/catch.h"
#include "tests/support/random.h"

using namespace pushback;

namespace {

constexpr Real h = Real(1) / 60;  // s

using Cold = Solver<Clamping, Baumgarte, Slop, Restitution, Friction>;

struct Minute {
  Real fell_after = -1;    ///< s, until a body was 2 m from where it began; -1: it stands
  Real farthest = 0;       ///< m, at any time
  Real last_speed = 0;     ///< m/s, the largest in the last second
  Real energy_gained = 0;  ///< J, the most over what it began with
};

/// A minute of a scene whose bodies begin up to 1 um off their places, in a way that `seed` decides. Ends where it falls.
template <class ContactSolver>
Minute minute_of(const std::function<void(World&)>& fill, Real dt, int sweeps, std::uint64_t seed) {
  World world;
  fill(world);
  Random random(seed);
  for (Body& body : world.bodies)
    if (body.movable()) body.position += random.vector(Real(1e-6));
  const World start = world;
  const Real before = potential_energy(world);
  ContactSolver solver;
  Minute seen;
  const int steps = static_cast<int>(std::lround(60 / dt));
  for (int step = 1; step <= steps; ++step) {
    world.step(solver, dt, sweeps);
    for (std::size_t i = 0; i < world.bodies.size(); ++i)
      seen.farthest = std::max(seen.farthest, (world.bodies[i].position - start.bodies[i].position).norm());
    seen.energy_gained = std::max(seen.energy_gained, kinetic_energy(world) + potential_energy(world) - before);
    if (static_cast<Real>(steps - step) * dt < 1) seen.last_speed = std::max(seen.last_speed, largest_speed(world));
    if (seen.farthest > 2) {
      seen.fell_after = static_cast<Real>(step) * dt;
      break;
    }
  }
  return seen;
}

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  REQUIRE(file.good());
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The cells of a line of CSV; a cell with commas stands in quotes.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    else if (c == ',' && !quoted) cells.emplace_back();
    else cells.back() += c;
  }
  return cells;
}

/// The number of the hard cases' table for that case, stage and criterion.
double hard_case(const std::string& name, const std::string& stage, const std::string& criterion) {
  std::istringstream lines(text_of("renders/hard_cases/table.csv"));
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> header = cells_of(line);
  const auto cell = [&](const std::vector<std::string>& cells, const std::string& column) {
    const auto at = std::find(header.begin(), header.end(), column);
    REQUIRE(at != header.end());
    return cells.at(static_cast<std::size_t>(at - header.begin()));
  };
  while (std::getline(lines, line)) {
    const std::vector<std::string> cells = cells_of(line);
    if (cell(cells, "case") == name && cell(cells, "stage") == stage && cell(cells, "criterion") == criterion)
      return std::stod(cell(cells, "number"));
  }
  FAIL("renders/hard_cases/table.csv has no " << name << ", " << stage << ", " << criterion);
  return 0;
}

}  // namespace

TEST_CASE("07: in steps of 1/120 s both piles fall cold and stand for a minute warm, from each of many starts",
          "[slow]") {
  struct Pile {
    std::string name;
    std::function<void(World&)> fill;
    int sweeps;
    std::uint64_t starts;
  };
  for (const Pile& pile : {Pile{"ten boxes", [](World& world) { stack(world, 10); }, 5, 30},
                           Pile{"a pyramid", [](World& world) { pyramid(world, 10); }, 2, 8}}) {
    for (std::uint64_t seed = 1; seed <= pile.starts; ++seed) {
      const Minute cold = minute_of<Cold>(pile.fill, h / 2, pile.sweeps, seed);
      const Minute warm = minute_of<FullSolver>(pile.fill, h / 2, pile.sweeps, seed);
      INFO(pile.name << ", start " << seed << ": cold falls after " << cold.fell_after << " s; warm is "
                     << warm.farthest << " m off at the most, " << warm.last_speed
                     << " m/s fast in the last second, gains " << warm.energy_gained << " J");
      CHECK(cold.fell_after > 0);
      CHECK(warm.fell_after < 0);
      CHECK(warm.farthest < Real(0.1));
      CHECK(warm.last_speed < Real(0.01));
      CHECK(warm.energy_gained == 0);
    }
  }
}

TEST_CASE("07: warm, ten boxes in steps of 1/60 s fall within a minute, unless they have twice the sweeps", "[slow]") {
  const auto ten_boxes = [](World& world) { stack(world, 10); };
  int fallen = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    fallen += minute_of<FullSolver>(ten_boxes, h, 10, seed).fell_after > 0;
    CHECK(minute_of<FullSolver>(ten_boxes, h, 20, seed).fell_after < 0);
  }
  INFO(fallen << " of 30 fall with ten sweeps");
  CHECK(fallen >= 10);
}

TEST_CASE("07: the page says of the hard case of ten boxes what its table has") {
  const std::string said = fmt::format("{:.0f} mm from where it began after 10 s, and moving at {:.0f} mm/s",
                                       hard_case("stack-10", "07 warm start", "drift after 10 s"),
                                       hard_case("stack-10", "07 warm start", "speed in the last second"));
  std::string page = text_of("chapters/07_warm_start/README.md");
  std::replace(page.begin(), page.end(), '\n', ' ');
  INFO("\"" << said << "\" is to stand there");
  CHECK(page.find(said) != std::string::npos);
}
