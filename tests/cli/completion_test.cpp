// SPDX-License-Identifier: GPL-3.0-or-later
// What bash, zsh and fish propose on a command line. Of zsh the functions that propose are replaced by ones
// that print, as its own want a terminal.
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include "cli/run_cli.h"
#include "cli/scene_files.h"
#include "deform/pipeline_kind.h"
#include "support/test_program.h"

namespace hitscope::completion_test {

using namespace test;

namespace {

/// Prints what it proposes for its arguments, of which the last is not yet at its end.
QString scriptOf(const QString& shell) {
    if (shell == QLatin1String("bash")) {
        return QStringLiteral(
            "source ./completion; COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); _hitscope_cli 2>/dev/null\n"
            "printf '%s\\n' \"${COMPREPLY[@]}\"\n");
    }
    if (shell == QLatin1String("zsh")) {
        return QStringLiteral(
            "_describe() { print -l -- ${(P)2} }\n"
            "_arguments() { print -l -- \"$@\" }\n"
            "words=(\"$@\"); CURRENT=$#; source ./completion\n");
    }
    return QStringLiteral("source ./completion; complete -C (string join ' ' -- $argv)\n");
}

}  // namespace

class CompletionTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void proposes_data();
    void proposes();

private:
    QTemporaryDir m_folder;
};

void CompletionTest::proposes_data() {
    QTest::addColumn<QString>("shell");
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("proposed");
    QTest::addColumn<QString>("notProposed");
    const auto row = [](const char* line, const char* proposed, const char* notProposed,
                        const QByteArray& proposedByZsh = {}) {
        for (const char* const shell : {"bash", "zsh", "fish"}) {
            const bool isOther = !proposedByZsh.isEmpty() && QLatin1String(shell) == QLatin1String("zsh");
            QTest::addRow("%s: %s", shell, line)
                << QString::fromLatin1(shell) << QString::fromLatin1(line)
                << QString::fromLatin1(isOther ? proposedByZsh : QByteArray(proposed))
                << QString::fromLatin1(notProposed);
        }
    };
    QByteArray keys;
    for (const PipelineTraits& traits : allPipelines()) {
        keys += ' ' + QByteArray(traits.key.data(), static_cast<qsizetype>(traits.key.size()));
    }
    row("sho", "shoot", "bench.json");
    row("bench fr", "frame", "shoot");
    row("bench frame --ge", "--gentle", "--random");
    row("bench frame --pipelines compute,re", "compute,reference", "bench.json", "_values -s , list" + keys);
    row("bench compare --to", "--tolerance", "--with");  // of bench compare, not of compare
    row("compare --wi", "--with", "--confidence");
    row("bench compare bench.j", "bench.json", "--with", "*:file:_files");
    row("bench frame x", "", "*:file:_files");
    row("help sho", "shoot", "bench.json");
    row("help bench fr", "frame", "bench.json");
    row("info two", "two words.json", "--with", "*:file:_files");
    row("shoot --hits two", "two words.json", "--with", "--hits=");
    row("shoot --pipeline comp", "compute", "bench.json", "(" + keys.trimmed());
}

void CompletionTest::proposes() {
    QFETCH(QString, shell);
    QFETCH(QString, line);
    QFETCH(QString, proposed);
    QFETCH(QString, notProposed);
    if (QStandardPaths::findExecutable(shell).isEmpty()) {
        QSKIP("It is not installed here.");
    }
    const auto in = [this](const char* name) { return m_folder.filePath(QLatin1String(name)); };
    writeBytes(in("bench.json"), "{}");
    writeBytes(in("two words.json"), "{}");
    writeBytes(in("xylophone.json"), "{}");
    writeBytes(in("completion"), runCli({"help", "--completion", shell}).out.toUtf8());
    writeBytes(in("ask"), scriptOf(shell).toUtf8());
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("HOME"), m_folder.path());
    process.setProcessEnvironment(environment);
    process.setWorkingDirectory(m_folder.path());
    process.start(shell, QStringList{in("ask"), QStringLiteral("hitscope-cli")} + line.split(u' '));
    QVERIFY(process.waitForFinished(60'000));
    const QString said = QString::fromUtf8(process.readAllStandardOutput());
    QVERIFY2(said.contains(proposed), qPrintable(said + process.readAllStandardError()));
    QVERIFY2(!said.contains(notProposed), qPrintable(said));
    if (proposed.isEmpty()) {
        QVERIFY2(!said.contains(QStringLiteral("xylophone")), qPrintable(said));
    }
}

HITSCOPE_TEST(CompletionTest, QCoreApplication)

}  // namespace hitscope::completion_test

#include "completion_test.moc"
