// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer: whatever bytes a session file has, they are refused with a message, or read as something that
// can be written and is the same then.
#include <cstdint>
#include <cstdlib>

#include "document/document_json.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace hitscope;
    const Result<SessionDocument> read = readDocument(
        QByteArray::fromRawData(reinterpret_cast<const char*>(data), static_cast<qsizetype>(size)));
    if (!read) {
        if (read.error().what.empty()) {
            std::abort();
        }
        return 0;
    }
    const QByteArray written = writeDocument(read.value());
    const Result<SessionDocument> again = readDocument(written);
    if (!again || writeDocument(again.value()) != written) {
        std::abort();
    }
    return 0;
}
