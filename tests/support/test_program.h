// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QTest>
#include <string_view>

namespace hitscope {

/// How long tests wait for something that has to come, milliseconds: drawn by the CPU on a busy machine, or
/// under a sanitizer, it takes its time.
inline constexpr int kPatience = 120'000;

}  // namespace hitscope

namespace hitscope::test {

using RunTest = int (*)(int argc, char** argv);

/// Makes a class of tests known to the program it is linked into, by the name of its file without
/// "_test.cpp".
struct Registration {
    Registration(std::string_view file, RunTest run);
};

/// What a class wants done before there is an application; QTEST_MAIN does it too.
template <class TestClass>
void initMain() {
    if constexpr (requires { TestClass::initMain(); }) {
        TestClass::initMain();
    }
}

}  // namespace hitscope::test

/// Once at the end of NAME_test.cpp, in place of QTEST_MAIN: all tests of a folder are one program, which
/// runs the class that its first argument names. Application: QCoreApplication, or QApplication where there
/// are widgets.
#define HITSCOPE_TEST(TestClass, Application)                                                       \
    static const hitscope::test::Registration registeredTests(__FILE__, [](int argc, char** argv) { \
        hitscope::test::initMain<TestClass>();                                                      \
        const Application application(argc, argv);                                                  \
        QCoreApplication::setAttribute(Qt::AA_Use96Dpi);                                            \
        TestClass tests;                                                                            \
        return QTest::qExec(&tests, argc, argv);                                                    \
    });
