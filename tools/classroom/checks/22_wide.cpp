#include "pushback/chapters/22_wide/colours.h"
#include "pushback/chapters/22_wide/exercise/asked.h"

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
  Real sum = 0;
  for (const int colour : colours) sum += static_cast<Real>(colour);
  return sum;
}
Real count_of(Colours colours) {
  std::sort(colours.begin(), colours.end());
  return static_cast<Real>(std::unique(colours.begin(), colours.end()) - colours.begin());
}

/// N s, by how much the momentum changes when balls of 1 kg that touch take on their common velocity, those of one colour side by
/// side: each pair reads both velocities before any of them writes one.
Real momentum_lost(const Graph& graph, const Colours& colours, Random& random) {
  std::vector<Real> velocities;
  for (std::size_t i = 0; i < graph.movable.size(); ++i) velocities.push_back(random.between(-1, 1));
  const auto momentum = [&] {
    Real sum = 0;
    for (const Real velocity : velocities) sum += velocity;
    return sum;
  };
  const Real before = momentum();
  Colours order = colours;
  std::sort(order.begin(), order.end());
  order.erase(std::unique(order.begin(), order.end()), order.end());
  for (const int colour : order) {
    const std::vector<Real> read = velocities;
    for (std::size_t i = 0; i < colours.size(); ++i) {
      const auto& [a, b] = graph.pairs[i];
      if (colours[i] == colour) velocities[a] = velocities[b] = (read[a] + read[b]) / 2;
    }
  }
  return std::abs(momentum() - before);
}

std::vector<Check<Answer>> checks() {
  return {
      {"pairs of one colour meet in no body, so no push is lost",
       2,
       {{"in your colouring two pairs of one colour meet in a body", "times", 0.5},
        {"solved side by side, your balls change their momentum by", "N s", 1e-6},
        {"the colours of your pairs, added up, are", "", 0.5}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Graph graph = some_graph(random, 0);
         const Colours colours = colours_by(answer, graph);
         return {clashes(graph, colours), momentum_lost(graph, colours, random), sum_of(colours)};
       }},
      {"what cannot move may be in any number of pairs of one colour",
       1,
       {{"with three bodies that cannot move, two pairs of one colour meet in one that can", "times", 0.5},
        {"with three bodies that cannot move, the colours of your pairs, added up, are", "", 0.5}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Graph graph = some_graph(random, 3);
         const Colours colours = colours_by(answer, graph);
         return {clashes(graph, colours), sum_of(colours)};
       }},
      {"a column of boxes needs two colours",
       1,
       {{"in your column two pairs of one colour meet in a box", "times", 0.5},
        {"your column has so many colours:", "", 0.5},
        {"the colours of your column's pairs, added up, are", "", 0.5},
        {"the colours of forty pairs that all meet in one body, added up, are", "", 0.5}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Graph graph = column(10 + random.below(10));
         const Colours colours = colours_by(answer, graph);
         Graph star{Movable(41, true), {}};
         for (std::size_t i = 1; i <= 40; ++i) star.pairs.push_back({0, i});
         return {clashes(graph, colours), count_of(colours), sum_of(colours), sum_of(colours_by(answer, star))};
       }},
  };
}

/// The chapter's own colours.
Colours right(const Pairs& pairs, const Movable& movable) {
  World world;
  for (const bool moves : movable) world.add(moves ? sphere(1, 1) : sphere(1, 1).fixed());
  std::vector<PairOfBodies> counted;
  for (const Pair& pair : pairs) counted.push_back({pair.a, pair.b, counted.size(), 1});
  Colours colours(pairs.size());
  const Sets sets = coloured(counted, world);
  for (std::size_t colour = 0; colour < sets.size(); ++colour)
    for (const PairOfBodies& pair : sets[colour]) colours[pair.first] = static_cast<int>(colour);
  return colours;
}

/// The rule of the page, and what can be done wrong in it.
struct Wrong {
  bool a_seen = true, b_seen = true, a_marked = true, b_marked = true;
  bool fixed_count = false, both_needed = false, above_all = false;
};

Colours greedy(const Pairs& pairs, const Movable& movable, const Wrong& wrong) {
  std::vector<std::uint64_t> taken(movable.size(), 0);
  Colours colours;
  for (const auto& [a, b] : pairs) {
    const auto seen_at = [&](std::size_t body, bool seen) {
      return seen && (movable[body] || wrong.fixed_count) ? taken[body] : 0;
    };
    const std::uint64_t at_a = seen_at(a, wrong.a_seen), at_b = seen_at(b, wrong.b_seen);
    const std::uint64_t both = wrong.both_needed ? at_a & at_b : at_a | at_b;
    const int colour = wrong.above_all ? 64 - std::countl_zero(both) : std::countr_one(both);
    colours.push_back(colour);
    if (wrong.a_marked) taken[a] |= std::uint64_t(1) << colour;
    if (wrong.b_marked) taken[b] |= std::uint64_t(1) << colour;
  }
  return colours;
}

std::vector<Mistake<Answer>> mistakes() {
  return {
      {"all in one set",
       "it looks as if all pairs had one colour. Two pairs that meet in a body both read its velocity and both write "
       "it: one of the two pushes is lost.",
       {[](const Pairs& pairs, const Movable&) { return Colours(pairs.size(), 0); }}},
      {"a colour for each pair",
       "it looks as if each pair had a colour of its own. That is one after the other again: nothing is solved side by "
       "side.",
       {[](const Pairs& pairs, const Movable&) {
         Colours colours;
         for (std::size_t i = 0; i < pairs.size(); ++i) colours.push_back(static_cast<int>(i));
         return colours;
       }}},
      {"two colours in turn",
       "it looks as if pairs had two colours in turn. That is right for a column alone: the colour depends on what the "
       "two bodies already have.",
       {[](const Pairs& pairs, const Movable&) {
         Colours colours;
         for (std::size_t i = 0; i < pairs.size(); ++i) colours.push_back(static_cast<int>(i % 2));
         return colours;
       }}},
      {"the ground shared",
       "it looks as if bodies that cannot move counted. Nothing changes their velocity, so pairs that meet only there "
       "can be solved side by side.",
       {[](const Pairs& pairs, const Movable& movable) { return greedy(pairs, movable, {.fixed_count = true}); }}},
      {"only A's colours",
       "it looks as if only the colours of body A were looked at. The colour has to be free in both bodies.",
       {[](const Pairs& pairs, const Movable& movable) { return greedy(pairs, movable, {.b_seen = false}); }}},
      {"only B's colours",
       "it looks as if only the colours of body B were looked at. The colour has to be free in both bodies.",
       {[](const Pairs& pairs, const Movable& movable) { return greedy(pairs, movable, {.a_seen = false}); }}},
      {"taken in A alone",
       "it looks as if the colour were noted for body A alone. B has it from now on, too.",
       {[](const Pairs& pairs, const Movable& movable) { return greedy(pairs, movable, {.b_marked = false}); }}},
      {"taken in B alone",
       "it looks as if the colour were noted for body B alone. A has it from now on, too.",
       {[](const Pairs& pairs, const Movable& movable) { return greedy(pairs, movable, {.a_marked = false}); }}},
      {"free in one of them",
       "it looks as if a colour counted as free when one of the two bodies does not have it. Neither may have it.",
       {[](const Pairs& pairs, const Movable& movable) { return greedy(pairs, movable, {.both_needed = true}); }}},
      {"above all that are taken",
       "it looks as if the colour were one more than the highest that either body has. Gaps below it stay unused, and "
       "there are more colours than are needed.",
       {[](const Pairs& pairs, const Movable& movable) { return greedy(pairs, movable, {.above_all = true}); }}},
      {"pairs with the ground left out",
       "it looks as if pairs with a body that cannot move had colour 0 in any case, and their other body did not take "
       "note. The body that can move is in that pair as in any other.",
       {[](const Pairs& pairs, const Movable& movable) {
         Pairs others;
         for (const Pair& pair : pairs)
           if (movable[pair.a] && movable[pair.b]) others.push_back(pair);
         const Colours of_others = greedy(others, movable, {});
         Colours colours;
         std::size_t next = 0;
         for (const Pair& pair : pairs) colours.push_back(movable[pair.a] && movable[pair.b] ? of_others[next++] : 0);
         return colours;
       }}},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return rebuild_of<Answer>(
      "pairs that may be solved side by side",
      {"Keep for each body which colours its pairs have so far: 64 bits are enough here.",
       "The colour of a pair is the first that neither of its bodies has; a body that cannot move never stands in the "
       "way.",
       "std::countr_one(taken[a] | taken[b]) is the number of the first free bit. Then set that bit in both."},
      checks(), {right}, mistakes());
}

}  // namespace pushback::exercise_22
