#include <numeric>

#include "pushback/chapters/22_wide/exercise/asked.h"
#include "pushback/engine/substeps/pair_colouring.h"
#include "pushback/tools/classroom/checks/scenes.h"

namespace pushback::exercise_22 {

namespace {

/// Bodies and which of them touch.
struct Graph {
  Movable movable;
  Pairs pairs;
};

Graph some_graph(Random& random, std::size_t fixed) {
  const std::size_t bodies = 16;
  Graph graph{Movable(bodies, true), {}};
  for (std::size_t i = 0; i < fixed; ++i) graph.movable[i] = false;
  for (std::size_t a = 0; a < bodies; ++a) {
    for (std::size_t b = a + 1; b < bodies; ++b) {
      const bool touch = random.below(2) == 0, turned = random.below(2) == 0;
      if (!touch || !(graph.movable[a] || graph.movable[b])) continue;
      graph.pairs.push_back(turned ? Pair{b, a} : Pair{a, b});
    }
  }
  random.shuffle(graph.pairs);
  return graph;
}
/// The first body is the ground.
Graph column(std::size_t boxes) {
  Graph graph{Movable(boxes + 1, true), {}};
  graph.movable[0] = false;
  for (std::size_t i = 0; i < boxes; ++i) graph.pairs.push_back({i, i + 1});
  return graph;
}

Colours colours_by(const Answer& answer, const Graph& graph) {
  Colours colours = answer.colours(graph.pairs, graph.movable);
  colours.resize(graph.pairs.size(), 0);
  return colours;
}

/// How often two pairs of one colour have a movable body in common.
Real clashes(const Graph& graph, const Colours& colours) {
  Real count = 0;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (colours[i] != colours[k]) continue;
      const Pair &p = graph.pairs[i], &q = graph.pairs[k];
      for (const std::size_t body : {p.a, p.b})
        if (graph.movable[body] && (body == q.a || body == q.b)) ++count;
    }
  }
  return count;
}
Real sum_of(const Colours& colours) {
  return static_cast<Real>(std::accumulate(colours.begin(), colours.end(), 0));
}

/// The chapter's own colours.
Colours right(const Pairs& pairs, const Movable& movable) {
  World world;
  for (const bool moves : movable) world.add(moves ? sphere(1, 1) : sphere(1, 1).fixed());
  std::vector<TouchingPair> counted;
  for (const Pair& pair : pairs) counted.push_back({pair.a, pair.b, counted.size(), 1});
  Colours colours(pairs.size());
  const PairSets sets = colour_pairs(counted, world);
  for (std::size_t colour = 0; colour < sets.size(); ++colour)
    for (const TouchingPair& pair : sets[colour]) colours[pair.first] = static_cast<int>(colour);
  return colours;
}

}  // namespace

std::vector<Check<Answer>> checks_of(const Answer& /*any*/) {
  return {
      {"pairs of one colour share no body, so no push is lost", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Graph graph = some_graph(random, 0);
         const Colours colours = colours_by(answer, graph);
         return {{"in your colouring, two pairs of one colour share a body", clashes(graph, colours), "times", 0.5},
                 {"the colours of your pairs add up to", sum_of(colours)}};
       },
       "if two pairs of one colour share a body, both read its velocity and both write it, so one of the two pushes is "
       "lost. A pair gets the first colour that neither body has."},
      {"a body that cannot move may be in any number of pairs of one colour", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Graph graph = some_graph(random, 3);
         const Colours colours = colours_by(answer, graph);
         return {{"with three fixed bodies, two pairs of one colour share a movable body", clashes(graph, colours),
                  "times", 0.5},
                 {"with three fixed bodies, the colours of your pairs add up to", sum_of(colours), "", 0.5}};
       },
       "nothing changes the velocity of a body that cannot move. Pairs of one colour may share only such bodies."},
      {"a column of boxes needs two colours", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Graph graph = column(10 + random.below(10));
         Graph star{Movable(41, true), {}};
         for (std::size_t i = 1; i <= 40; ++i) star.pairs.push_back({0, i});
         return {{"the colours of your column's pairs add up to", sum_of(colours_by(answer, graph))},
                 {"the colours of forty pairs that all share one body add up to", sum_of(colours_by(answer, star))}};
       },
       "a pair gets the first colour that neither of its bodies has so far. A higher colour would add a set, and sets "
       "are solved one after another."},
  };
}

Exercise exercise() {
  return rebuild_of(
      "pairs that may be solved side by side",
      {"For each body, remember which colours its pairs have so far. 64 bits are enough here.",
       "The colour of a pair is the first one that neither of its bodies has. A body that cannot move rules out no "
       "colour.",
       "std::countr_one(taken[a] | taken[b]) is the index of the first free bit. Then set this bit in both."},
      Answer{right});
}

}  // namespace pushback::exercise_22
