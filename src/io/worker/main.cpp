// SPDX-License-Identifier: GPL-3.0-or-later
// hitscope-import INPUT SECONDS BYTES: reads a mesh file of any known format and writes it in the form of
// io/mesh_stream.h to its standard input, which is a file without a name that the program made; what it says
// on its standard output is described in io/worker_protocol.h. A process of its own, so that a file that
// makes a parser crash, hang or eat all memory costs a message and nothing else; and locked (sandbox.h), so
// that one that takes the parser over gets nothing by it.
#include <unistd.h>

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QStringList>
#include <chrono>
#include <cstdio>
#include <exception>
#include <new>

#include "io/mesh_stream.h"
#include "io/readers/read_mesh.h"
#include "io/worker/limits.h"
#include "io/worker/sandbox.h"
#include "io/worker_protocol.h"

namespace {

using namespace hitscope;

constexpr double kReadingShare = 0.85;  // of the progress; writing the result is the rest

void say(const WorkerMessage& message) {
    const QByteArray line = formatWorkerLine(message);
    std::fwrite(line.constData(), 1, static_cast<std::size_t>(line.size()), stdout);
    std::fflush(stdout);
}

/// At most ten times a second.
class Progress {
public:
    void operator()(double fraction, const char* doing) {
        const auto now = std::chrono::steady_clock::now();
        if (now - m_last >= std::chrono::milliseconds(100)) {
            m_last = now;
            say(WorkerProgress{fraction * kReadingShare, QString::fromLatin1(doing)});
        }
    }

private:
    std::chrono::steady_clock::time_point m_last{};
};

Status convert(const QString& input) {
    const Result<ImportedMesh> imported = readMesh(input, Progress());
    if (!imported) {
        return imported.error();
    }
    for (const QString& note : imported.value().notes) {
        say(WorkerNote{note});
    }
    say(WorkerProgress{kReadingShare, QStringLiteral("Handing over")});
    QFile answer;
    if (!answer.open(STDIN_FILENO, QIODevice::WriteOnly | QIODevice::Unbuffered)) {
        return Error{"The mesh that was read cannot be handed over.", kAnswerPlace,
                     "Try opening the file again."};
    }
    const Status written = writeMeshStream(imported.value().mesh, answer);
    return written ? written : Error{written.error().what, kAnswerPlace, written.error().advice};
}

Status convertCaught(const QString& input) {
    try {
        return convert(input);
    } catch (const std::bad_alloc&) {
        return Error{"Reading the file needs more memory than it may have.", input.toStdString(),
                     "The file may be damaged; otherwise split it, or open a smaller mesh."};
    } catch (const std::exception& other) {
        return Error{std::string("The reader gave up: ") + other.what() + ".", input.toStdString(),
                     "Try opening and saving the file with another program."};
    }
}

}  // namespace

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.size() != 4) {
        std::fputs("hitscope-import is started by Hitscope: hitscope-import INPUT SECONDS BYTES\n", stderr);
        return 2;
    }
    const QString& input = arguments[1];
    limitThisProcess(arguments[2].toULongLong(), arguments[3].toULongLong(),
                     static_cast<std::uint64_t>(QFileInfo(input).size()));
    loadWhatComesLate();
    lockThisProcess(input);
    if (const Status converted = convertCaught(input); !converted) {
        say(converted.error());
        return 1;
    }
    return 0;
}
