// SPDX-License-Identifier: GPL-3.0-or-later
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "document/document_json.h"
#include "document_support.h"
#include "io_support.h"
#include "support/test_program.h"

namespace hitscope::document_schema_test {

using namespace test;

namespace {

struct Run {
    int status = -1;
    QString said;
};

Run python(const QString& program, const QStringList& arguments) {
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(program, arguments);
    if (!process.waitForFinished(60'000) || process.exitStatus() != QProcess::NormalExit) {
        return {};
    }
    return {process.exitCode(), QString::fromUtf8(process.readAll())};
}

/// The first that has the package jsonschema; empty: none.
QString pythonWithSchemas() {
    for (const char* program : {"python3", "/usr/bin/python3"}) {
        if (python(QLatin1String(program), {"-c", "import jsonschema"}).status == 0) {
            return QLatin1String(program);
        }
    }
    return {};
}

}  // namespace

/// What is written is as the schema beside the program says.
class DocumentSchemaTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void files_data();
    void files();

private:
    QTemporaryDir m_folder;
    QString m_python;
};

void DocumentSchemaTest::initTestCase() {
    m_python = pythonWithSchemas();
    if (m_python.isEmpty()) {
        QSKIP("Python's package jsonschema is not here.");
    }
}

void DocumentSchemaTest::files_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("problem");
    SessionDocument document = exampleDocument();
    QTest::newRow("one of everything") << writeDocument(document) << QString();
    QTest::newRow("nothing") << writeDocument(SessionDocument()) << QString();
    for (int mesh = 0; mesh < 7; ++mesh) {
        document.targets[static_cast<std::size_t>(mesh % 3)].source.mesh = static_cast<BuiltInMesh>(mesh);
    }
    document.targets[2].source = {};
    document.hits[0].pipeline = 200;
    document.hits[1].pipeline = kUnknownPipeline;
    document.cameras.current.clear();
    document.selection = {};
    QTest::newRow("others") << writeDocument(document) << QString();
    // That the schema says something.
    QTest::newRow("newer") << writeDocument(document).replace("\"version\": 1", "\"version\": 2")
                           << "version";
    QTest::newRow("unknown") << writeDocument(document).replace("\"impulse\"", "\"oomph\"") << "oomph";
    QTest::newRow("wrong kind") << writeDocument(document).replace("\"impulse\": 41", "\"impulse\": \"41\"")
                                << "is not of type";
}

void DocumentSchemaTest::files() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, problem);
    const QString file = writeFile(m_folder.path(), QStringLiteral("a.hitscope"), bytes.toStdString());
    const Run run = python(
        m_python, {"-c",
                   "import json, sys, jsonschema\n"
                   "schema = json.load(open(sys.argv[1], encoding='utf-8'))\n"
                   "jsonschema.Draft202012Validator.check_schema(schema)\n"
                   "checker = jsonschema.Draft202012Validator(schema)\n"
                   "problems = [str(list(e.absolute_path)) + ' ' + e.message "
                   "for e in checker.iter_errors(json.load(open(sys.argv[2], encoding='utf-8')))]\n"
                   "print('\\n'.join(problems))\n"
                   "sys.exit(1 if problems else 0)\n",
                   QStringLiteral(HITSCOPE_SHADERS "/../resources/schemas/session.schema.json"), file});
    if (problem.isEmpty()) {
        QVERIFY2(run.status == 0, qPrintable(run.said));
    } else {
        QCOMPARE(run.status, 1);
        QVERIFY2(run.said.contains(problem), qPrintable(run.said));
    }
}

HITSCOPE_TEST(DocumentSchemaTest, QCoreApplication)

}  // namespace hitscope::document_schema_test

#include "document_schema_test.moc"
