#include "pushback/tools/measure/frozen/siconos.h"

#include <FrictionContactProblem.h>
#include <Friction_cst.h>
#include <NonSmoothDrivers.h>
#include <NumericsVerbose.h>
#include <SolverOptions.h>
#include <fc3d_compute_error.h>
#include <sn_error_handling.h>

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "pushback/chapters/16_whole_problem/problem_file.h"
#include "pushback/common/basics/named.h"
#include "pushback/tools/measure/study/stopwatch.h"

namespace pushback::frozen {

namespace {

struct Method {
  const char* name;
  int id;
};
constexpr Method methods[] = {{"Siconos NSGS", SICONOS_FRICTION_3D_NSGS},
                              {"Siconos NSN_AC", SICONOS_FRICTION_3D_NSN_AC},
                              {"Siconos ADMM", SICONOS_FRICTION_3D_ADMM}};

template <class T, auto free>
struct Freed {
  void operator()(T* what) const { free(what); }
};
using Problem = std::unique_ptr<FrictionContactProblem, Freed<FrictionContactProblem, frictionContactProblem_free>>;
using Options = std::unique_ptr<SolverOptions, Freed<SolverOptions, solver_options_delete>>;

/// Through the text of its own format: every number in as many digits as give the same bits. A new one for each call, since
/// the solvers keep what they make of a matrix beside it.
Problem in_siconos(const ContactProblem& problem) {
  std::string text = problem_text(problem);
  const std::unique_ptr<std::FILE, Freed<std::FILE, std::fclose>> file(fmemopen(text.data(), text.size(), "r"));
  if (!file) throw std::runtime_error("no memory for a problem of Siconos");
  Problem made(frictionContact_newFromFile(file.get()));
  if (!made) throw std::runtime_error("Siconos does not read the problem");
  return made;
}

/// Siconos keeps it for the whole program; it prints by that.
void be_silent() {
  numerics_set_verbose(0);
}

/// What it calls fatal is a jump to here, or the program's end where nobody waits. So nothing in here has a destructor.
bool drive(FrictionContactProblem* problem, double* r, double* u, SolverOptions* options, int* info) {
  if (SN_SETJMP_EXTERNAL_START != 0) return false;
  *info = fc3d_driver(problem, r, u, options);
  SN_SETJMP_EXTERNAL_STOP
  return true;
}

}  // namespace

std::vector<std::string> siconos_methods() {
  return names_of(methods);
}

namespace {

/// What a process of its own sends back, and the impulses after it.
struct Sent {
  int iterations = 0, info = 1;
  double seconds = 0;
};

void send(int pipe, const void* what, std::size_t size) {
  for (const char* at = static_cast<const char*>(what); size > 0;) {
    const ssize_t sent = write(pipe, at, size);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) return;
    at += sent;
    size -= static_cast<std::size_t>(sent);
  }
}

/// Whether so much came.
bool receive(int pipe, void* what, std::size_t size) {
  for (char* at = static_cast<char*>(what); size > 0;) {
    const ssize_t got = read(pipe, at, size);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    at += got;
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

/// Whether there is something to read, or the other end is closed.
bool answers_within(double seconds, int pipe) {
  pollfd end{pipe, POLLIN, 0};
  return poll(&end, 1, static_cast<int>(1000 * seconds)) != 0;
}

void solve_and_send(int pipe, const ContactProblem& problem, int id, double tolerance, int iterations) {
  be_silent();
  const Problem made = in_siconos(problem);
  const Options options(solver_options_create(id));
  options->dparam[SICONOS_DPARAM_TOL] = tolerance;
  options->iparam[SICONOS_IPARAM_MAX_ITER] = iterations;
  Vector r = Vector::Zero(problem.q.size()), u = r;
  Sent sent;
  Stopwatch solving;
  solving.go();
  const bool came_back = drive(made.get(), r.data(), u.data(), options.get(), &sent.info);
  solving.stop();
  if (!came_back) return;
  sent.iterations = options->iparam[SICONOS_IPARAM_ITER_DONE];
  sent.seconds = solving.seconds();
  send(pipe, &sent, sizeof sent);
  send(pipe, r.data(), sizeof(double) * static_cast<std::size_t>(r.size()));
}

}  // namespace

// In a process of its own: Siconos 4.4 does not give back all the memory that it takes, and after some hundreds of calls there
// is none left.
SiconosAnswer solve_by_siconos(const ContactProblem& problem, const std::string& method, double tolerance,
                               int iterations, double patience) {
  const Method& asked = named("method", methods, method);
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe to a process for Siconos");
  std::fflush(nullptr);  // or what waits there would be printed twice
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process for Siconos");
  if (child == 0) {
    close(ends[0]);
    int status = 0;
    try {
      solve_and_send(ends[1], problem, asked.id, tolerance, iterations);
    } catch (...) {
      status = 1;
    }
    _exit(status);
  }
  close(ends[1]);
  Sent sent;
  SiconosAnswer answer{.r = Vector::Zero(problem.q.size())};
  const bool in_time = answers_within(patience, ends[0]);
  if (!in_time) kill(child, SIGKILL);
  const bool came_back = in_time && receive(ends[0], &sent, sizeof sent) &&
                         receive(ends[0], answer.r.data(), sizeof(double) * static_cast<std::size_t>(answer.r.size()));
  close(ends[0]);
  while (waitpid(child, nullptr, 0) < 0 && errno == EINTR) continue;
  if (!in_time) {
    answer.seconds = patience;
    return answer;
  }
  if (!came_back) throw std::runtime_error(method + " has given up by what Siconos calls a fatal error");
  answer.iterations = sent.iterations;
  answer.reached = sent.info == 0;
  answer.seconds = sent.seconds;
  return answer;
}

double siconos_error(const ContactProblem& problem, const Vector& r) {
  be_silent();
  const Problem made = in_siconos(problem);
  const Options options(solver_options_create(SICONOS_FRICTION_3D_NSGS));  // a place for its workings
  Vector at = r, u = Vector::Zero(r.size());
  double error = 0;
  const double unit = problem.q.norm();
  fc3d_compute_error(made.get(), at.data(), u.data(), 1, options.get(), unit > 0 ? unit : 1, &error);
  return error;
}

}  // namespace pushback::frozen
