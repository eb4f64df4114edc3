#include "core/base/child_process.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ; // NOLINT(readability-redundant-declaration): POSIX wants it declared

namespace ramure {
namespace {

constexpr std::size_t kept = 4096;

/// A child in a group of its own, whose output comes through a pipe.
class Child
{
public:
    explicit Child(const std::vector<std::string>& words)
    {
        std::array<int, 2> ends{};
        if (pipe2(ends.data(), O_CLOEXEC) != 0) {
            m_problem = errno;
            return;
        }
        m_pipe = ends[0];
        posix_spawn_file_actions_t files;
        posix_spawnattr_t attributes;
        posix_spawn_file_actions_init(&files);
        posix_spawnattr_init(&attributes);
        posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_adddup2(&files, ends[1], 1);
        posix_spawn_file_actions_adddup2(&files, ends[1], 2);
        posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
        posix_spawnattr_setpgroup(&attributes, 0);
        std::vector<char*> arguments;
        for (const std::string& word : words)
            arguments.push_back(const_cast<char*>(word.c_str())); // NOLINT: it does not write to them
        arguments.push_back(nullptr);
        m_problem = posix_spawnp(&m_id, arguments[0], &files, &attributes, arguments.data(), environ);
        posix_spawn_file_actions_destroy(&files);
        posix_spawnattr_destroy(&attributes);
        close(ends[1]);
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child()
    {
        if (m_id > 0) {
            kill(-m_id, SIGKILL);
            wait();
        }
        if (m_pipe >= 0)
            close(m_pipe);
    }

    [[nodiscard]] int problem() const { return m_problem; }
    /// Waits a moment for output. False: there will be no more.
    bool read(std::string& said)
    {
        pollfd watched{m_pipe, POLLIN, 0};
        constexpr int moment = 50; // ms
        if (poll(&watched, 1, moment) <= 0)
            return true;
        std::array<char, kept> block{};
        const ssize_t count = ::read(m_pipe, block.data(), block.size());
        if (count <= 0)
            return count < 0 && errno == EINTR;
        said.append(block.data(), static_cast<std::size_t>(count));
        if (said.size() > kept)
            said.erase(0, said.size() - kept);
        return true;
    }
    int wait()
    {
        int state = 0;
        while (waitpid(m_id, &state, 0) < 0 && errno == EINTR) {
        }
        m_id = 0;
        return WIFSIGNALED(state) ? 128 + WTERMSIG(state) : WEXITSTATUS(state);
    }

private:
    pid_t m_id = 0;
    int m_pipe = -1, m_problem = 0;
};

} // namespace

bool isInstalled(const std::string& program)
{
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (access((folder + "/" + program).c_str(), X_OK) == 0)
            return true;
    return false;
}

Expected<ProcessResult> runProcess(const std::vector<std::string>& words, const Progress& progress)
{
    Child child(words);
    if (child.problem() != 0)
        return fail(ErrorCode::Io, RAMURE_NOOP("%1 cannot be started: %2"),
                    {words.front(), std::strerror(child.problem())});
    ProcessResult out;
    while (child.read(out.said))
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
    out.exitCode = child.wait();
    return out;
}

} // namespace ramure
