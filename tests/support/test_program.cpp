// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/test_program.h"

#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "core/kept_libraries.h"

namespace hitscope::test {
namespace {

std::map<std::string, RunTest, std::less<>>& known() {
    static std::map<std::string, RunTest, std::less<>> tests;
    return tests;
}

}  // namespace

Registration::Registration(std::string_view file, RunTest run) {
    constexpr std::string_view kEnd = "_test.cpp";
    file.remove_prefix(file.find_last_of('/') + 1);
    file.remove_suffix(file.ends_with(kEnd) ? kEnd.size() : 0);
    known().emplace(file, run);
}

}  // namespace hitscope::test

/// PROGRAM NAME [Qt Test's arguments…]
int main(int argc, char** argv) {
    auto& tests = hitscope::test::known();
    const auto chosen = argc > 1 ? tests.find(std::string_view(argv[1])) : tests.end();
    if (chosen == tests.end()) {
        std::fprintf(stderr, "Usage: %s NAME [arguments of Qt Test]; NAME is one of\n", argv[0]);
        for (const auto& test : tests) {
            std::fprintf(stderr, "  %s\n", test.first.c_str());
        }
        return 2;
    }
    // Qt Test would end what takes five minutes, however busy the machine; CTest ends what hangs.
    setenv("QTEST_FUNCTION_TIMEOUT", "3600000", 0);  // milliseconds
    std::vector<char*> arguments(argv, argv + argc);
    arguments.erase(arguments.begin() + 1);
    arguments.push_back(nullptr);
    return chosen->second(argc - 1, arguments.data());
}
