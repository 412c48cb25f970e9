// SPDX-License-Identifier: GPL-3.0-or-later
// hitscope-import INPUT OUTPUT SECONDS BYTES: reads a mesh file of any known format and writes it in the form
// of io/mesh_stream.h; what it says on its standard output is described in io/worker_protocol.h. A process of
// its own, so that a file that makes a parser crash, hang or eat all memory costs a message and nothing else.
#include <QCoreApplication>
#include <QStringList>
#include <chrono>
#include <cstdio>
#include <exception>
#include <new>

#include "io/mesh_stream.h"
#include "io/readers/read_mesh.h"
#include "io/worker/limits.h"
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

Status convert(const QString& input, const QString& output) {
    const Result<ImportedMesh> imported = readMesh(input, Progress());
    if (!imported) {
        return imported.error();
    }
    for (const QString& note : imported.value().notes) {
        say(WorkerNote{note});
    }
    say(WorkerProgress{kReadingShare, QStringLiteral("Handing over")});
    return writeMeshStream(imported.value().mesh, output);
}

Status convertCaught(const QString& input, const QString& output) {
    try {
        return convert(input, output);
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
    if (arguments.size() != 5) {
        std::fputs("hitscope-import is started by Hitscope: hitscope-import INPUT OUTPUT SECONDS BYTES\n",
                   stderr);
        return 2;
    }
    limitThisProcess(arguments[3].toULongLong(), arguments[4].toULongLong());
    if (const Status converted = convertCaught(arguments[1], arguments[2]); !converted) {
        say(converted.error());
        return 1;
    }
    return 0;
}
