#include "base/process.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <list>
#include <optional>
#include <utility>  // boost/asio.hpp 1.74 uses std::exchange without it

#include <boost/asio.hpp>
#include <boost/process.hpp>
#include <boost/process/extend.hpp>
#include <boost/process/posix.hpp>
#include <fcntl.h>
#include <fmt/format.h>
#include <linux/close_range.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/descriptors.h"
#include "base/error.h"
#include "base/stopwatch.h"

namespace lightbench {
namespace asio = boost::asio;
namespace bp = boost::process;
namespace {

constexpr auto kKillDelay = std::chrono::seconds(2);
/// A child's own children may hold its pipes open; after its end they get this long.
constexpr auto kDrainTime = std::chrono::milliseconds(500);
/// A child is idle after so many looks in a row at a clock that stands still: where we were stopped
/// ourselves, time that went by does not count.
constexpr int kIdleLooks = 4;

/// Processor time of a child, with all its threads.
std::chrono::nanoseconds processor_time(pid_t child) {
  clockid_t clock{};
  timespec time{};
  if (::clock_getcpuclockid(child, &clock) != 0 || ::clock_gettime(clock, &time) != 0) return {};
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

double seconds_of(const timeval& time) {
  return double(time.tv_sec) + 1e-6 * double(time.tv_usec);
}

double cpu_seconds_of(const rusage& usage) {
  return seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
}

/// Our own variables, "NAME=value", with some added or replaced. Not bp::environment: 1.74 reads past the end
/// of variables that are shorter than the one it looks for.
std::vector<std::string> environment_with(const std::map<std::string, std::string>& added) {
  std::vector<std::string> result;
  for (char** variable = ::environ; *variable; ++variable) {
    const std::string_view text = *variable;
    if (!added.contains(std::string(text.substr(0, text.find('='))))) result.emplace_back(text);
  }
  for (const auto& [name, value] : added) result.push_back(name + "=" + value);
  return result;
}

/// Runs in the child before it becomes the program.
void prepare_child() {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::signal(SIGPIPE, SIG_DFL);  // which this program ignores
  // The pipes of other children would keep those from ending.
  if (::close_range(3, ~0U, CLOSE_RANGE_CLOEXEC) == 0) return;
  for (int descriptor = 3; descriptor < 1024; ++descriptor) ::fcntl(descriptor, F_SETFD, FD_CLOEXEC);
}

/// Not a pipe: that would have to be filled while the child works, and would end us where it does not read.
Descriptor input_of(const ProcessOptions& options) {
  return options.input.empty() ? Descriptor(::open("/dev/null", O_RDONLY | O_CLOEXEC))
                               : file_in_memory(options.input);
}

bool is_ignored(int signal) {
  struct sigaction action {};
  return ::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

void keep_last(std::string& text, std::size_t limit) {
  if (text.size() > 2 * limit) text.erase(0, text.size() - limit);
}

}  // namespace

std::string ProcessResult::describe() const {
  if (stalled)
    return fmt::format("stalled: it used no processor time any more, and was ended after {:.0f} s", seconds);
  if (timed_out) return fmt::format("timed out after {:.0f} s", seconds);
  if (signal) return fmt::format("killed by signal {} ({})", signal, ::strsignal(signal));
  return fmt::format("exit code {}", exit_code);
}

struct ProcessLoop::Impl {
  /// One running child: its pipes, its timers, and what it said so far.
  struct Job {
    Job(asio::io_context& io, LineHandler line, ExitHandler exit)
        : out(io),
          err(io),
          timer(io),
          idle_timer(io),
          kill_timer(io),
          drain_timer(io),
          on_line(std::move(line)),
          on_exit(std::move(exit)) {}

    bp::async_pipe out, err;
    asio::steady_timer timer, idle_timer, kill_timer, drain_timer;
    std::array<char, 4096> out_block{}, err_block{};
    std::string partial_line;
    std::size_t longest_line = 0;
    bp::child child;
    bp::group group;
    LineHandler on_line;
    ExitHandler on_exit;
    Stopwatch watch;
    std::size_t keep_output = 0;
    std::chrono::nanoseconds processor_time{0};
    int idle_looks = 0;
    int open_pipes = 2;
    bool ended = false;
    ProcessResult result;
  };
  using JobIterator = std::list<Job>::iterator;

  asio::io_context io;
  asio::signal_set child_signal{io, SIGCHLD};
  std::optional<asio::signal_set> stop_signals;
  std::list<Job> jobs;
  std::list<asio::steady_timer> tick_timers;
  int stop_signal = 0;

  void start(const ProcessOptions& options, LineHandler on_line, ExitHandler on_exit);
  void read(JobIterator job, bool is_out);
  void take_output(JobIterator job, bool is_out, std::string_view bytes);
  static void add_to_line(Job& job, std::string_view bytes);
  void wait_for_children();
  void reap();
  void finish_if_drained(JobIterator job);
  void terminate(JobIterator job);
  void watch_idleness(JobIterator job, std::chrono::milliseconds interval);
  void tick(std::list<asio::steady_timer>::iterator timer, std::chrono::milliseconds interval,
            const std::function<void()>& action);
  void run();
};

void ProcessLoop::Impl::start(const ProcessOptions& options, LineHandler on_line, ExitHandler on_exit) {
  if (options.argv.empty()) throw Error("no program to run");
  const auto program = find_program(options.argv.front());
  if (program.empty())
    throw Error("no such program (is it installed, and on the PATH?)", options.argv.front());
  std::vector<std::string> variables = environment_with(options.environment);
  std::vector<char*> environment;
  for (std::string& variable : variables) environment.push_back(variable.data());
  environment.push_back(nullptr);
  const std::vector<std::string> arguments(options.argv.begin() + 1, options.argv.end());
  const std::string folder = options.working_directory.empty() ? std::filesystem::current_path().string()
                                                               : options.working_directory.string();

  const Descriptor input = input_of(options);
  if (!input)
    throw Error(fmt::format("cannot be given its input: {}", std::strerror(errno)), program.string());

  const auto job = jobs.emplace(jobs.end(), io, std::move(on_line), std::move(on_exit));
  job->keep_output = options.keep_output;
  job->longest_line = options.longest_line;
  try {
    job->child = bp::child(
        bp::exe = program.string(), bp::args = arguments, bp::start_dir = folder,
        bp::posix::fd.bind(STDIN_FILENO, input.number()), bp::std_out > job->out, bp::std_err > job->err,
        job->group, bp::extend::on_setup = [&](auto& executor) { executor.env = environment.data(); },
        bp::extend::on_exec_setup = [](auto&) { prepare_child(); });
  } catch (const bp::process_error& error) {
    jobs.erase(job);
    throw Error(fmt::format("cannot be started: {}", error.code().message()), program.string());
  }
  read(job, true);
  read(job, false);
  if (options.timeout.count() > 0) {
    job->timer.expires_after(options.timeout);
    job->timer.async_wait([this, job](const boost::system::error_code& error) {
      if (error || job->ended) return;
      job->result.timed_out = true;
      terminate(job);
    });
  }
  if (options.idle_timeout.count() > 0) watch_idleness(job, options.idle_timeout / kIdleLooks);
}

void ProcessLoop::Impl::watch_idleness(JobIterator job, std::chrono::milliseconds interval) {
  job->idle_timer.expires_after(interval);
  job->idle_timer.async_wait([this, job, interval](const boost::system::error_code& error) {
    if (error || job->ended) return;
    const auto used = processor_time(job->child.id());
    job->idle_looks = used == job->processor_time ? job->idle_looks + 1 : 0;
    job->processor_time = used;
    if (job->idle_looks < kIdleLooks) return watch_idleness(job, interval);
    job->result.stalled = true;
    terminate(job);
  });
}

void ProcessLoop::Impl::read(JobIterator job, bool is_out) {
  auto& pipe = is_out ? job->out : job->err;
  auto& block = is_out ? job->out_block : job->err_block;
  pipe.async_read_some(asio::buffer(block),
                       [this, job, is_out](const boost::system::error_code& error, std::size_t size) {
                         const auto& filled = is_out ? job->out_block : job->err_block;
                         take_output(job, is_out, {filled.data(), size});
                         if (!error) return read(job, is_out);
                         --job->open_pipes;
                         finish_if_drained(job);
                       });
}

void ProcessLoop::Impl::take_output(JobIterator job, bool is_out, std::string_view bytes) {
  auto& kept = is_out ? job->result.out : job->result.err;
  kept += bytes;
  keep_last(kept, job->keep_output);
  if (!is_out || !job->on_line) return;
  for (std::size_t end; (end = bytes.find('\n')) != std::string_view::npos; bytes.remove_prefix(end + 1)) {
    add_to_line(*job, bytes.substr(0, end));
    job->on_line(std::exchange(job->partial_line, ""));
  }
  add_to_line(*job, bytes);
}

void ProcessLoop::Impl::add_to_line(Job& job, std::string_view bytes) {
  job.partial_line += bytes.substr(0, job.longest_line - job.partial_line.size());
}

void ProcessLoop::Impl::wait_for_children() {
  child_signal.async_wait([this](const boost::system::error_code& error, int) {
    if (error) return;
    reap();
    wait_for_children();
  });
}

/// wait4 rather than the library's own wait: it tells the CPU time of that very child.
void ProcessLoop::Impl::reap() {
  for (auto job = jobs.begin(); job != jobs.end();) {
    const auto current = job++;
    if (current->ended) continue;
    int status = 0;
    rusage usage{};
    if (::wait4(current->child.id(), &status, WNOHANG, &usage) != current->child.id()) continue;
    auto& result = current->result;
    result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    result.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    result.seconds = current->watch.seconds();
    result.cpu_seconds = cpu_seconds_of(usage);
    ::killpg(current->group.native_handle(), SIGKILL);
    current->child.detach();
    current->ended = true;
    current->drain_timer.expires_after(kDrainTime);
    current->drain_timer.async_wait([current](const boost::system::error_code& error) {
      if (error) return;
      current->out.close();
      current->err.close();
    });
    finish_if_drained(current);
  }
}

void ProcessLoop::Impl::finish_if_drained(JobIterator job) {
  if (!job->ended || job->open_pipes > 0) return;
  job->timer.cancel();
  job->idle_timer.cancel();
  job->kill_timer.cancel();
  job->drain_timer.cancel();
  for (auto* text : {&job->result.out, &job->result.err})
    if (text->size() > job->keep_output) text->erase(0, text->size() - job->keep_output);
  // Cancelled timers still hold the iterator until their handlers have run, so the job goes last.
  asio::post(io, [this, job] {
    const ExitHandler on_exit = std::move(job->on_exit);
    const ProcessResult result = std::move(job->result);
    jobs.erase(job);
    if (on_exit) on_exit(result);
    if (jobs.empty()) io.stop();
  });
}

void ProcessLoop::Impl::terminate(JobIterator job) {
  if (job->ended) return;
  ::killpg(job->group.native_handle(), SIGTERM);
  job->kill_timer.expires_after(kKillDelay);
  job->kill_timer.async_wait([job](const boost::system::error_code& error) {
    if (!error && !job->ended) ::killpg(job->group.native_handle(), SIGKILL);
  });
}

void ProcessLoop::Impl::tick(std::list<asio::steady_timer>::iterator timer,
                             std::chrono::milliseconds interval, const std::function<void()>& action) {
  timer->expires_after(interval);
  timer->async_wait([this, timer, interval, action](const boost::system::error_code& error) {
    if (error) return;
    action();
    tick(timer, interval, action);
  });
}

void ProcessLoop::Impl::run() {
  if (jobs.empty()) return;
  stop_signals.emplace(io);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    if (!is_ignored(signal)) stop_signals->add(signal);
  stop_signals->async_wait([this](const boost::system::error_code& error, int signal) {
    if (error) return;
    stop_signal = signal;
    for (auto job = jobs.begin(); job != jobs.end(); ++job) terminate(job);
  });
  io.restart();
  reap();  // a child may have ended before anyone listened
  io.run();
  stop_signals.reset();
}

ProcessLoop::ProcessLoop() : impl_(std::make_unique<Impl>()) {
  impl_->wait_for_children();
}

ProcessLoop::~ProcessLoop() {
  for (auto& job : impl_->jobs) {
    if (job.ended) continue;
    ::killpg(job.group.native_handle(), SIGKILL);
    ::waitpid(job.child.id(), nullptr, 0);
    job.child.detach();
  }
}

void ProcessLoop::start(const ProcessOptions& options, LineHandler on_line, ExitHandler on_exit) {
  impl_->start(options, std::move(on_line), std::move(on_exit));
}

void ProcessLoop::every(std::chrono::milliseconds interval, const std::function<void()>& tick) {
  impl_->tick(impl_->tick_timers.emplace(impl_->tick_timers.end(), impl_->io), interval, tick);
}

void ProcessLoop::run() {
  impl_->run();
}
bool ProcessLoop::interrupted() const {
  return impl_->stop_signal != 0;
}

void ProcessLoop::terminate_all() {
  for (auto job = impl_->jobs.begin(); job != impl_->jobs.end(); ++job) impl_->terminate(job);
}

ProcessResult run_process(const ProcessOptions& options) {
  ProcessResult result;
  bool interrupted = false;
  {
    ProcessLoop loop;
    loop.start(options, nullptr, [&](const ProcessResult& r) { result = r; });
    loop.run();
    interrupted = loop.interrupted();
  }
  // The signal was meant for us; the child went first. The loop is gone, and its handlers with it.
  if (interrupted) ::raise(SIGTERM);
  return result;
}

double own_cpu_seconds() {
  double seconds = 0;
  for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    ::getrusage(who, &usage);
    seconds += cpu_seconds_of(usage);
  }
  return seconds;
}

std::filesystem::path find_program(const std::string& name) {
  if (name.find('/') != std::string::npos)
    return ::access(name.c_str(), X_OK) == 0 && !std::filesystem::is_directory(name)
               ? std::filesystem::absolute(name)
               : std::filesystem::path();
  return bp::search_path(name).string();
}

}  // namespace lightbench
