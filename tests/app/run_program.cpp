#include "app/run_program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>

#include "base/files.h"

namespace partonomy {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
    static std::atomic<int> count = 0;
    path_ =
        fs::temp_directory_path() / ("partonomy-test-" + std::to_string(::getpid()) + "-" + std::to_string(count++));
    fs::create_directories(path_);
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

std::string TemporaryFolder::write(const std::string& name, const std::string& bytes) const {
    write_file(path_ / name, bytes);
    return (path_ / name).string();
}

ProgramResult run_partonomy(const std::vector<std::string>& arguments, const fs::path& folder) {
    const TemporaryFolder captured;
    const std::string out = (captured.path() / "out").string(), err = (captured.path() / "err").string();
    const pid_t child = ::fork();
    if (child == 0) {
        std::vector<char*> argv = {const_cast<char*>(PARTONOMY_BINARY)};
        for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
        argv.push_back(nullptr);
        const int out_file = ::open(out.c_str(), O_WRONLY | O_CREAT, 0600),
                  err_file = ::open(err.c_str(), O_WRONLY | O_CREAT, 0600);
        ::dup2(out_file, STDOUT_FILENO);
        ::dup2(err_file, STDERR_FILENO);
        if (::chdir(folder.c_str()) != 0) ::_exit(127);
        ::execv(argv[0], argv.data());
        ::_exit(127);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(out), read_file(err)};
}

std::string furniture_path() { return PARTONOMY_SOURCE_DIR "/ontologies/furniture.ttl"; }

}  // namespace partonomy
