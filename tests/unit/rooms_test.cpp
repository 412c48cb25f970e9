// SPDX-License-Identifier: GPL-3.0-or-later
// The table of HACKING.md's map: what a folder of src includes stands above it, and OpenGL stays where it is.
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QSet>
#include <QTest>
#include <map>

#include "support/test_program.h"

namespace hitscope::rooms_test {

namespace {

const std::map<QString, QStringList>& mayInclude() {
    static const std::map<QString, QStringList> table = [] {
        std::map<QString, QStringList> rooms;
        rooms["core"] = {};
        rooms["usage"] = {"core"};
        rooms["mesh"] = {"core"};
        rooms["deform"] = rooms["mesh"] + QStringList{"mesh"};
        rooms["view"] = rooms["deform"] + QStringList{"deform"};
        rooms["physics"] = rooms["view"];
        rooms["physics"].removeOne("view");
        rooms["physics"] << "deform";
        rooms["io"] = rooms["physics"];
        rooms["session"] = rooms["io"] + QStringList{"view", "physics", "io"};
        rooms["document"] = rooms["session"] + QStringList{"session"};
        rooms["analysis"] = rooms["session"] + QStringList{"session"};
        rooms["gl"] = {"core"};
        rooms["pipeline"] = {"core", "mesh", "deform", "gl"};
        rooms["render"] = rooms["pipeline"] + QStringList{"view", "pipeline"};
        rooms["scene"] = rooms["analysis"] + QStringList{"analysis", "gl", "pipeline", "render"};
        rooms["models"] = rooms["analysis"] + QStringList{"analysis"};
        rooms["panels"] = rooms["models"] + QStringList{"models"};
        rooms["viewport"] = rooms["scene"] + QStringList{"scene"};
        rooms["app"] = rooms["panels"] + QStringList{"panels", "scene", "viewport", "document", "usage"};
        rooms["bench_window"] = rooms["app"] + QStringList{"app"};
        rooms["cli"] = rooms["scene"] + QStringList{"scene", "document", "models", "usage"};
        return rooms;
    }();
    return table;
}

struct File {
    QStringList ours;    ///< included with quotes, from src
    QStringList others;  ///< with angle brackets
};

QString roomOf(const QString& file) {
    return file.section('/', 0, 0);
}

/// By path from src.
std::map<QString, File> filesOf(const QString& folder) {
    std::map<QString, File> files;
    QDirIterator it(folder, {"*.h", "*.cpp"}, QDir::Files, QDirIterator::Subdirectories);
    while (it.hasNext()) {
        QFile file(it.next());
        if (!file.open(QIODevice::ReadOnly)) {
            qFatal("%s: %s", qPrintable(file.fileName()), qPrintable(file.errorString()));
        }
        File& entry = files[QDir(folder).relativeFilePath(file.fileName())];
        static const QRegularExpression include("^#include ([\"<])([^\">]+)",
                                                QRegularExpression::MultilineOption);
        for (const auto& match : include.globalMatch(QString::fromUtf8(file.readAll()))) {
            (match.captured(1) == "<" ? entry.others : entry.ours) << match.captured(2);
        }
    }
    return files;
}

/// Over which files `file` comes to a header of OpenGL; empty: it does not.
QStringList wayToOpenGl(const std::map<QString, File>& files, const QString& file, QSet<QString>& seen) {
    const auto found = files.find(file);
    if (found == files.end() || seen.contains(file)) {
        return {};
    }
    seen.insert(file);
    if (found->second.others.contains("epoxy/gl.h")) {
        return {file};
    }
    for (const QString& included : found->second.ours) {
        const QStringList way = wayToOpenGl(files, included, seen);
        if (!way.isEmpty()) {
            return QStringList{file} + way;
        }
    }
    return {};
}

}  // namespace

class RoomsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        m_files = filesOf(QStringLiteral(HITSCOPE_SHADERS "/../src"));
        QVERIFY(m_files.size() > 400);
    }

    void foldersIncludeWhatStandsAboveThem() {
        QStringList wrong;
        for (const auto& [file, entry] : m_files) {
            const auto room = mayInclude().find(roomOf(file));
            QVERIFY2(room != mayInclude().end(), qPrintable(file + " is in no room of HACKING.md's map"));
            for (const QString& included : entry.ours) {
                if (m_files.contains(included) && roomOf(included) != room->first &&
                    !room->second.contains(roomOf(included))) {
                    wrong << file + " includes " + included;
                }
            }
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
    }

    /// epoxy's header and Qt's OpenGL headers cannot be in one file.
    void openGlStaysWhereItIsCalled() {
        const QStringList calls = {"gl", "pipeline", "render"};
        QStringList wrong;
        for (const auto& [file, entry] : m_files) {
            if (entry.others.contains("epoxy/gl.h") && !calls.contains(roomOf(file)) &&
                !file.startsWith("cli/bench_gl/")) {
                wrong << file;
            }
            if (QStringList{"session", "document", "analysis", "view", "models", "panels", "viewport", "app"}
                    .contains(roomOf(file))) {
                QSet<QString> seen;
                wrong << wayToOpenGl(m_files, file, seen).join(" > ");
            }
        }
        wrong.removeAll(QString());
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
    }

    void noFolderIsCrowded() {
        std::map<QString, int> counts;
        for (const auto& [file, entry] : m_files) {
            ++counts[file.section('/', 0, -2)];
        }
        for (const auto& [folder, count] : counts) {
            QVERIFY2(count <= 65, qPrintable(QStringLiteral("%1: %2 files").arg(folder).arg(count)));
        }
    }

private:
    std::map<QString, File> m_files;
};

HITSCOPE_TEST(RoomsTest, QCoreApplication)

}  // namespace hitscope::rooms_test

#include "rooms_test.moc"
