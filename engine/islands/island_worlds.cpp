#include "pushback/engine/islands/island_worlds.h"

#include "pushback/engine/islands/step_contacts.h"

namespace pushback {

namespace {

bool has_world(const StepClassifier& classifier, int body) {
  return classifier.step_of(body) == StepType::half_steps || classifier.is_moved_by_fast(body);
}

}  // namespace

void IslandWorlds::add_bodies(const World& world, StepClassifier& classifier) {
  count_ = 0;
  place_.assign(world.bodies.size(), -1);
  for (const Body& body : world.bodies) {
    if (!has_world(classifier, body.index)) continue;
    const int lowest = classifier.island_of(body.index);
    int& place = place_[std::size_t(lowest)];
    if (place < 0) {
      place = static_cast<int>(count_);
      if (count_ == islands_.size()) islands_.emplace_back();
      islands_[count_++].begin(world, lowest);
    }
    islands_[std::size_t(place)].add(body.index);
  }
}

/// Null if the bodies have no world in common.
IslandWorld* IslandWorlds::island_of(const Body& a, const Body& b, StepClassifier& classifier) {
  const int moving = (a.movable() ? a : b).index;
  if (!has_world(classifier, moving)) return nullptr;
  if (a.movable() && b.movable() && classifier.island_of(a.index) != classifier.island_of(b.index)) return nullptr;
  return &islands_[std::size_t(place_[std::size_t(classifier.island_of(moving))])];
}

void IslandWorlds::divide(World& world, StepClassifier& classifier, const Contacts& found) {
  add_bodies(world, classifier);
  if (count_ == 0) return;
  each_pair(found, [&](PairContacts between) {
    const auto [a, b] = world.bodies_of(between.front());
    if (a.movable() && b.movable()) return;
    if (IslandWorld* island = island_of(a, b, classifier)) island->add((a.movable() ? b : a).index);
  });
  for (const Joint& joint : world.joints)
    if (IslandWorld* island = island_of(world.body(joint.a), world.body(joint.b), classifier))
      for (const int body : {joint.a, joint.b})
        if (body != the_world) island->add(body);
  for (std::size_t i = 0; i < count_; ++i) islands_[i].sort();
  each_pair(world.contacts, [&](PairContacts between) {
    const auto [a, b] = world.bodies_of(between.front());
    if (IslandWorld* island = island_of(a, b, classifier)) island->add(between);
  });
  for (std::size_t i = 0; i < world.joints.size(); ++i) {
    Joint& joint = world.joints[i];
    if (IslandWorld* island = island_of(world.body(joint.a), world.body(joint.b), classifier))
      island->take_joint(joint, i);
  }
}

void IslandWorlds::give_found(const World& world, StepClassifier& classifier, const Contacts& found) {
  each_pair(found, [&](PairContacts between) {
    const auto [a, b] = world.bodies_of(between.front());
    if (!classifier.is_moved_by_fast((a.movable() ? a : b).index) || between.front().id.feature == no_feature) return;
    if (IslandWorld* island = island_of(a, b, classifier)) island->add_found(between);
  });
}

void IslandWorlds::give_joints(World& world) {
  for (std::size_t i = 0; i < count_; ++i) islands_[i].give_joints(world.joints);
}

void IslandWorlds::commit(World& world, Real fraction) const {
  const auto lower = [](const Contact& first, const Contact& second) { return first.id < second.id; };
  Contacts& contacts = world.contacts;
  // The ends of sorted runs. The first run has the other contacts, and each further one has those of an island.
  std::vector<std::size_t> ends{0, contacts.size()};
  for (std::size_t i = 0; i < count_; ++i) {
    if (!islands_[i].moved) continue;
    islands_[i].write_to(world, fraction);
    if (contacts.size() > ends.back()) ends.push_back(contacts.size());
  }
  const auto at = [&](std::size_t end) { return contacts.begin() + static_cast<std::ptrdiff_t>(end); };
  while (ends.size() > 2) {  // neighbouring runs become one
    std::size_t kept = 1;
    for (std::size_t i = 2; i < ends.size(); i += 2) {
      std::inplace_merge(at(ends[i - 2]), at(ends[i - 1]), at(ends[i]), lower);
      ends[kept++] = ends[i];
    }
    if (ends.size() % 2 == 0) ends[kept++] = ends.back();
    ends.resize(kept);
  }
  world.last_impulses_known = true;
}

}  // namespace pushback
