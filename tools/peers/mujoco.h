/// What of ours becomes what of MuJoCo's.
#pragma once

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <array>
#include <cstring>
#include <memory>
#include <stdexcept>

#include "pushback/common/bodies/body.h"

namespace pushback {

inline std::string text(const Vec3& v) {
  return fmt::format("{:.17g} {:.17g} {:.17g}", v.x(), v.y(), v.z());
}

inline std::string text(const Quat& q) {
  return fmt::format("{:.17g} {:.17g} {:.17g} {:.17g}", q.w(), q.x(), q.y(), q.z());
}

struct ReleaseMujoco {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using MujocoModel = std::unique_ptr<mjModel, ReleaseMujoco>;
using MujocoData = std::unique_ptr<mjData, ReleaseMujoco>;

inline MujocoModel model_of(const std::string& mjcf) {
  mju_user_warning = [](const char*) {};  // its own writes a file; lost_by asks
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "world.xml", static_cast<int>(mjcf.size()));
  std::memcpy(files->filedata[0], mjcf.data(), mjcf.size());
  std::array<char, 1000> problem{};
  MujocoModel model(mj_loadXML("world.xml", files.get(), problem.data(), static_cast<int>(problem.size())));
  mj_deleteVFS(files.get());
  if (model == nullptr) throw std::runtime_error(fmt::format("MuJoCo: {}", problem.data()));
  return model;
}

/// What went wrong so far; null: nothing. MuJoCo begins anew by itself where a state is no number.
inline const char* lost_by(const mjData& data) {
  for (const int lost : {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC, mjWARN_CONTACTFULL, mjWARN_CNSTRFULL})
    if (data.warning[lost].number > 0) return mju_warningText(lost, 0);
  return nullptr;
}

}  // namespace pushback
