// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/memory.h"
#include "support/test_program.h"

#include <QTest>
#include <cstdlib>
#include <memory>
#include <vector>

#include "support/test_program.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

using namespace hitscope;

class MemoryTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void freedBlocksStayWithTheLibrary();
};

void MemoryTest::freedBlocksStayWithTheLibrary() {
#ifdef __SANITIZE_ADDRESS__
    QSKIP("The address sanitizer has a malloc of its own.");
#endif
#ifdef __GLIBC__
    constexpr std::size_t kBlock = 64 << 10;
    constexpr std::size_t kBlocks = 512;
    keepFreedMemory();
    std::vector<std::unique_ptr<char[]>> blocks(kBlocks);
    for (auto& block : blocks) {
        block = std::make_unique<char[]>(kBlock);
    }
    blocks.clear();
    QVERIFY2(mallinfo2().fordblks >= kBlocks * kBlock, "the system has it back");
#else
    QSKIP("only glibc is told what to keep");
#endif
}

HITSCOPE_TEST(MemoryTest, QCoreApplication)
#include "memory_test.moc"
