/// The work budgets of all islands.
#pragma once

#include <vector>

#include "pushback/engine/islands/step_classifier.h"
#include "pushback/engine/islands/work_budget.h"

namespace pushback {

class WorkBudgets {
 public:
  /// Pools the savings of the bodies of each island.
  void pool(const World& world, StepClassifier& classifier, const WorkBudgetSettings& settings) {
    const double at_first = settings.at_first * settings.per_contact;
    by_body_.resize(world.bodies.size(), WorkBudget(at_first));
    by_island_.assign(world.bodies.size(), WorkBudget());
    for (const Body& body : world.bodies)
      if (body.movable()) of(classifier.island_of(body.index)).add(by_body_[std::size_t(body.index)]);
  }
  /// Whether the island can pay for half steps, if its contacts are many.
  bool can_pay(int island, const StepClassifier& classifier, const WorkBudgetSettings& settings) {
    return !classifier.many_contacts(island) || of(island).can_pay(price(island, classifier, settings));
  }
  /// Adds to the savings of islands with many contacts that got substeps, and gives each body its share.
  void share_out(const World& world, StepClassifier& classifier, const WorkBudgetSettings& settings) {
    for (const Body& body : world.bodies) {
      const int i = body.index;
      if (!body.movable() || classifier.island_of(i) != i || !classifier.many_contacts(i) ||
          classifier.step_of(i) != StepType::substeps)
        continue;
      const double work = price(i, classifier, settings);
      of(i).save(settings.fraction * work, settings.most * work);
    }
    for (const Body& body : world.bodies)
      if (body.movable()) by_body_[std::size_t(body.index)] = of(classifier.island_of(body.index)).share();
  }
  WorkBudget& of(int island) { return by_island_[std::size_t(island)]; }
  /// The work of substeps in a step, in multiplications. If Fast moves the island, it is the work of Fast.
  static double price(int island, const StepClassifier& classifier, const WorkBudgetSettings& settings) {
    return (classifier.was_large(island) ? work_of_fast : 1) * settings.per_contact * classifier.contacts(island);
  }

 private:
  static constexpr double work_of_fast = 0.125;  // as a fraction of the work of 32 substeps in double

  std::vector<WorkBudget> by_body_;
  std::vector<WorkBudget> by_island_;  // by the lowest body of each island
};

}  // namespace pushback
