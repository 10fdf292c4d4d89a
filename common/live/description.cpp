/// Describes an experiment and its problem to a page, in JSON.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pushback/common/basics/files.h"
#include "pushback/common/experiment/marker.h"
#include "pushback/common/experiment/words.h"
#include "pushback/common/live/live.h"
#include "pushback/common/render/palette.h"

namespace pushback {

namespace {

std::string in_json(const Vec3& v) {
  return fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z());
}

const char* in_json(bool yes) {
  return yes ? "true" : "false";
}

std::string in_json(const Ink& ink) {
  return fmt::format("\"#{:02x}{:02x}{:02x}\"", ink.red, ink.green, ink.blue);
}

template <class List, class Each>
std::string array_of(const List& list, const Each& each) {
  std::vector<std::string> all;
  for (const auto& one : list) all.push_back(each(one));
  return fmt::format("[{}]", fmt::join(all, ",\n"));
}

}  // namespace

std::string Live::description() const {
  const auto name_of = [](const auto& one) { return pushback::quoted(one.name); };
  const auto in_full = [this](const Variant& variant) {
    const auto colour = static_cast<std::size_t>(variant.colour);
    return fmt::format(
        R"({{"name": {}, "colour": "{}", "marker": "{}", "sweeps": {}, "curves": {}, "references": {}}})",
        pushback::quoted(variant.name), line_colour(colour), marker_of(colour), experiment_.sweeps_of(variant),
        in_json(variant.curves),
        array_of(variant.references, [](const Reference& reference) { return pushback::quoted(reference.label); }));
  };
  const auto meaning = [](const std::pair<Ink, std::string>& one) {
    return fmt::format(R"({{"colour": {}, "text": {}}})", in_json(one.first), pushback::quoted(one.second));
  };
  std::vector<std::string> scenes;
  for (std::size_t a = 0; a < experiment_.scene_records_.size(); ++a) {
    const Experiment::SceneRecord& record = experiment_.scene_records_[a];
    const Scene& scene = record.scene;
    const double aspect =
        scene.strobe ? 1520.0 / scene.strobe->height : 500.0 / (scene.cell_height > 0 ? scene.cell_height : 281);
    std::string series = array_of(record.series, [](const Experiment::Quantity& quantity) {
      return fmt::format(R"({{"name": {}, "unit": {}, "log": {}, "drawn": {}}})", pushback::quoted(quantity.name),
                         pushback::quoted(quantity.unit), in_json(quantity.log_y), in_json(quantity.drawn));
    });
    if (record.series.empty()) series = R"([{"name": "deepest overlap", "unit": "mm", "log": false, "drawn": true}])";
    scenes.push_back(fmt::format(
        R"({{"name": {}, "key": {}, "caption": {}, "pictures": {}, "steps": {}, "aspect": {}, "strobe": {}, "contacts": {}, "impulses": {},
"camera": {{"eye": {}, "target": {}, "field_of_view": {}}},
"colours": {}, "raster": {}, "series": {},
"numbers": {},
"variants": {}}})",
        pushback::quoted(scene.name), pushback::quoted(key_of(scene)), pushback::quoted(scene.caption),
        in_json(scene.pictures), experiment_.steps_of(scene), aspect, in_json(scene.strobe.has_value()),
        in_json(scene.contacts != Drawn::nothing), in_json(scene.contacts == Drawn::impulses),
        in_json(scene.camera.eye), in_json(scene.camera.target), scene.camera.field_of_view,
        array_of(scene.colours, meaning),
        scene.raster ? fmt::format(R"({{"label": {}, "meaning": {}}})", pushback::quoted(scene.raster->label),
                                   array_of(scene.raster->meaning, meaning))
                     : "null",
        series,
        array_of(record.numbers,
                 [](const Experiment::Number& number) {
                   return fmt::format(R"({{"name": {}, "unit": {}}})", pushback::quoted(number.name),
                                      pushback::quoted(number.unit));
                 }),
        array_of(variants_of(a), [&](const Variant* variant) { return in_full(*variant); })));
  }
  return fmt::format(R"({{"name": {}, "dt": {}, "problems": {}, "rows": {}, "scenes": [{}]}})",
                     pushback::quoted(experiment_.name_), experiment_.dt_, array_of(experiment_.problems_, name_of),
                     array_of(experiment_.rows_, name_of), fmt::join(scenes, ",\n"));
}

std::string Live::problem() const {
  const IteratedProblem& problem = iterated().problem();
  std::vector<std::string> methods;
  for (std::size_t i = 0; i < problem.methods.size(); ++i)
    methods.push_back(fmt::format(R"({{"name": {}, "colour": "{}", "marker": "{}"}})",
                                  pushback::quoted(problem.methods[i].name), line_colour(i), marker_of(i)));
  return fmt::format(
      R"({{"rows": {}, "block": {}, "blockName": {}, "iteration": {}, "measure": {}, "most": {}, "methods": [{}]}})",
      problem.matrix.rows(), problem.block, pushback::quoted(problem.block_name), pushback::quoted(problem.iteration),
      pushback::quoted(problem.measure), problem.most, fmt::join(methods, ", "));
}

}  // namespace pushback
