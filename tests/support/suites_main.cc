#include "tests/support/suite.h"

#include <cstdio>
#include <filesystem>
#include <map>
#include <string>

namespace ramure::test {

// Filled before main(), in whatever order the suites are linked.
static std::map<std::string, Suite::Run>& allSuites()
{
    static std::map<std::string, Suite::Run> all;
    return all;
}

Suite::Suite(const char* file, Run run)
{
    if (!allSuites().emplace(std::filesystem::path(file).stem().string(), run).second)
        qFatal("two suites are named like %s", file);
}

} // namespace ramure::test

int main(int argc, char** argv)
{
    const auto& all = ramure::test::allSuites();
    const auto wanted = argc > 1 ? all.find(argv[1]) : all.end();
    if (wanted == all.end()) {
        std::fprintf(stderr, "Usage: %s SUITE [OPTION OF QTEST]...\nSuites:\n", argv[0]);
        for (const auto& [name, run] : all)
            std::fprintf(stderr, "  %s\n", name.c_str());
        return 2;
    }
    argv[1] = argv[0];
    return wanted->second(argc - 1, argv + 1);
}
