#include "pushback/tools/classroom/own_tasks.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/input.h"
#include "pushback/common/basics/process.h"
#include "pushback/tools/classroom/attempt.h"
#include "pushback/tools/classroom/kit.h"
#include "pushback/tools/classroom/student_files.h"

namespace pushback {

namespace fs = std::filesystem;

namespace {

/// A hash of everything that a compiled exercise depends on.
std::uint64_t state_of(const fs::path& folder) {
  std::string all = read_text_file(kit().folder / "compile.txt");
  for (const std::string& library : kit().words_of("link.txt"))
    if (fs::exists(library))
      all += fmt::format("{} {} {}\n", library, fs::file_size(library),
                         fs::last_write_time(library).time_since_epoch().count());
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) all += file.string() + read_text_file(file);
  return hash_of(all);
}

void compile(const fs::path& folder, const std::string& name, const fs::path& object, const fs::path& library) {
  fmt::print(stderr, "compiling the task {}\n", name);
  const ScratchFolder scratch;
  const fs::path source = scratch.path / "task.cpp", made = scratch.path / "task.o", shared = scratch.path / "task.so";
  write_text_file(source,
                  fmt::format("#include {0}\n#define student untouched\n#include {1}\nextern \"C\" void "
                              "pushback_task(pushback::Exercise& made) {{\n  using namespace pushback;\n  made = "
                              "exercise_{2}::exercise();\n  made.untouched = [](std::size_t check, Random& "
                              "random) {{ return play(check, random, untouched::answer); }};\n}}\n",
                              quoted(folder / "checks.cpp"), quoted(folder / "student.h"), name));
  const Command compiler = kit().words_of("compile.txt");
  const Command compiled =
      compiler + Command{"-fPIC", "-ffunction-sections", "-fdata-sections", "-c", source, "-o", made};
  const Command linked{compiler[0], "-shared", "-o", shared, made};
  // A student's program links the object, but must not be able to name the right answer in it.
  const Command hidden{"objcopy", "--wildcard", "--localize-symbol=_ZN8pushback*8exerciseEv",
                       "--localize-symbol=pushback_task", made};
  for (const Command& step : {compiled, linked, hidden}) {
    const Ended ended = run_program(step);
    if (ended.status != 0) throw InvalidInput(fmt::format("--tasks: {} does not compile:\n{}", name, ended.err));
  }
  fs::create_directories(object.parent_path());
  for (const auto& old : fs::directory_iterator(object.parent_path()))
    if (old.path().stem() != object.stem()) fs::remove(old.path());
  write_text_file(object, read_text_file(made));
  write_text_file(library, read_text_file(shared));
}

Exercise loaded(const fs::path& folder) {
  const std::string name = folder.filename().string();
  for (const char* file : {"asked.h", "student.h", "task.md"})
    if (!fs::exists(folder / file)) throw InvalidInput(fmt::format("--tasks: {} has no {}", name, file));
  if (name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") != std::string::npos)
    throw InvalidInput(fmt::format("--tasks: a folder is named '{}': small letters, digits and _ are needed", name));
  const std::string built = folder / ".built" / fmt::format("{:016x}", state_of(folder));
  if (!fs::exists(built + ".so")) compile(folder, name, built + ".o", built + ".so");
  void* const library = dlopen((built + ".so").c_str(), RTLD_NOW | RTLD_LOCAL);  // never closed: its code is used
  if (!library) throw InvalidInput(fmt::format("--tasks: {} cannot be loaded: {}", name, dlerror()));
  Exercise made;
  reinterpret_cast<void (*)(Exercise&)>(dlsym(library, "pushback_task"))(made);
  made.name = name;
  made.folder = folder;
  made.object = built + ".o";
  return made;
}

}  // namespace

std::vector<Exercise> exercises_with(const fs::path& tasks) {
  std::vector<Exercise> all = all_exercises();
  if (tasks.empty()) return all;
  if (!fs::is_directory(tasks)) throw InvalidInput(fmt::format("--tasks: '{}' is no folder", tasks.string()));
  std::vector<fs::path> folders;
  for (const auto& entry : fs::directory_iterator(fs::canonical(tasks)))
    if (fs::exists(entry.path() / "checks.cpp")) folders.push_back(entry.path());
  if (folders.empty())
    throw InvalidInput(fmt::format(
        "--tasks: '{}' has no exercises: a folder each, with asked.h, student.h, checks.cpp and task.md, is needed",
        tasks.string()));
  std::sort(folders.begin(), folders.end());
  for (const fs::path& folder : folders) {
    for (const Exercise& other : all)
      if (other.name == folder.filename())
        throw InvalidInput(fmt::format("--tasks: an exercise named {} already exists", other.name));
    all.push_back(loaded(folder));
  }
  return all;
}

}  // namespace pushback
