// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer: whatever bytes a journal has, it is refused with a message, or comes to a session that can be
// saved and opened. The input is the lines without their checksums, which no fuzzer guesses.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "deform/fingerprint.h"
#include "document/document_json.h"
#include "document/journal_records.h"

namespace {

/// With the checksums that the lines should have.
QByteArray summed(std::string_view lines) {
    std::string text;
    for (std::uint64_t number = 0; !lines.empty(); ++number) {
        const std::string_view line = lines.substr(0, lines.find('\n'));
        lines.remove_prefix(line.size());
        hitscope::Fingerprint print;
        print.add(number);
        for (const char c : line) {
            print.add(static_cast<std::uint8_t>(c));
        }
        text += hitscope::fingerprintText(print.value()) + ' ';
        text += line;
        if (!lines.empty()) {
            text += '\n';
            lines.remove_prefix(1);
        }
    }
    return QByteArray::fromStdString(text);
}

void tryIt(const QByteArray& bytes) {
    using namespace hitscope;
    const Result<RecoveredJournal> read = readJournal(bytes);
    if (!read) {
        if (read.error().what.empty()) {
            std::abort();
        }
        return;
    }
    const QByteArray written = writeDocument(read.value().document);
    const Result<SessionDocument> again = readDocument(written);
    if (!again || writeDocument(again.value()) != written) {
        std::abort();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    tryIt(QByteArray::fromRawData(text.data(), static_cast<qsizetype>(text.size())));
    tryIt(summed(text));
    return 0;
}
