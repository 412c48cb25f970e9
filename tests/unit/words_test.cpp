// SPDX-License-Identifier: GPL-3.0-or-later
// The interface uses the words of docs/glossary.md.
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTest>
#include <QXmlStreamReader>
#include <algorithm>

#include "support/test_program.h"

namespace hitscope::words_test {

namespace {

struct Text {
    QString file;
    QString text;  ///< without mnemonics
};

QString read(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QStringList filesBelow(const QString& folder, const QStringList& patterns) {
    QStringList paths;
    QDirIterator files(QStringLiteral(HITSCOPE_SHADERS "/..") + folder, patterns, QDir::Files,
                       QDirIterator::Subdirectories);
    while (files.hasNext()) {
        paths.append(files.next());
    }
    paths.sort();
    return paths;
}

/// What `pattern` captures in the file, of "…" "…" without what lies between the two.
void addMatches(const QString& path, const QRegularExpression& pattern, std::vector<Text>& texts) {
    static const QRegularExpression seam(QStringLiteral("\"\\s*\""));
    for (const QRegularExpressionMatch& match : pattern.globalMatch(read(path))) {
        if (match.hasCaptured(1)) {
            texts.push_back({path, match.captured(1).trimmed().remove(seam).remove(u'&')});
        }
    }
}

/// All literals of tr("…" "…") and of what is marked for it, with or without a context: "hitscope::Panel".
void addCode(const QString& path, std::vector<Text>& texts) {
    // Escaped, not raw: moc loses its way in raw strings with quotes.
    static const QRegularExpression call(
        QStringLiteral("\\b(?:tr|translate|QT_TR_NOOP|QT_TRANSLATE_NOOP|(?:HITSCOPE_)?TEXT)\\("
                       "\\s*(?:\"[\\w:]+\",\\s*)?((?:\"(?:[^\"\\\\]|\\\\.)*\"\\s*)+)"));
    addMatches(path, call, texts);
}

/// All literals outside comments: command lines, descriptions of parameters and errors are not marked.
void addLiterals(const QString& path, std::vector<Text>& texts) {
    static const QRegularExpression literal(
        QStringLiteral("//[^\n]*|/\\*.*?\\*/|#include[^\n]*|'(?:[^'\\\\\n]|\\\\.)'|"
                       "((?:\"(?:[^\"\\\\\n]|\\\\.)*\"\\s*)+)"),
        QRegularExpression::DotMatchesEverythingOption);
    addMatches(path, literal, texts);
}

void addForm(const QString& path, std::vector<Text>& texts) {
    QXmlStreamReader form(read(path));
    while (!form.atEnd()) {
        if (form.readNext() == QXmlStreamReader::StartElement && form.name() == u"string") {
            texts.push_back({path, form.readElementText().remove(u'&')});
        }
    }
}

std::vector<Text> interfaceTexts(void (*add)(const QString&, std::vector<Text>&) = addCode) {
    std::vector<Text> texts;
    for (const QString& path :
         filesBelow(QStringLiteral("/src"), {QStringLiteral("*.cpp"), QStringLiteral("*.h")})) {
        add(path, texts);
    }
    for (const QString& path : filesBelow(QStringLiteral("/ui"), {QStringLiteral("*.ui")})) {
        addForm(path, texts);
    }
    return texts;
}

/// The last column of the glossary's table.
QStringList wordsNotUsed() {
    QStringList words;
    for (const QString& line : read(QStringLiteral(HITSCOPE_SHADERS "/../docs/glossary.md")).split(u'\n')) {
        const QStringList cells = line.split(u'|');
        if (cells.size() == 5) {
            for (const QString& word : cells[3].split(u',')) {
                words.append(word.trimmed());
            }
        }
    }
    words.removeAll(QString());
    words.removeAll(QStringLiteral("not"));
    words.removeAll(QStringLiteral("---"));
    return words;
}

}  // namespace

class WordsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// One of each way to write them.
    void textsAreFound() {
        const std::vector<Text> marked = interfaceTexts();
        QVERIFY(marked.size() > 1200);
        const auto isIn = [](const std::vector<Text>& texts, const char* text) {
            return std::any_of(texts.begin(), texts.end(), [text](const Text& one) {
                return QString(one.text).remove(u'"') == QLatin1String(text);
            });
        };
        for (const char* text : {"Speed of the projectile just before the hit", "Constants of %Ln Hits",
                                 "Average of the changed vertices' displacements.", "Add Primitive"}) {
            QVERIFY2(isIn(marked, text), text);
        }
        const std::vector<Text> all = interfaceTexts(addLiterals);
        for (const char* text : {"How far the vertex is from where it was",
                                 "shoot a mesh, see exactly what moved, save the result", "Add Primitive"}) {
            QVERIFY2(isIn(all, text), text);
        }
    }

    void wordsOfTheGlossaryAreUsed() {
        const std::vector<Text> texts = interfaceTexts(addLiterals);
        const QStringList words = wordsNotUsed();
        QVERIFY(words.contains(QStringLiteral("most alive")));
        QStringList wrong;
        for (const QString& word : words) {
            // LP is an abbreviation only in capitals.
            const auto options = word == word.toUpper() ? QRegularExpression::NoPatternOption
                                                        : QRegularExpression::CaseInsensitiveOption;
            const QRegularExpression found(QStringLiteral("\\b%1\\b").arg(QRegularExpression::escape(word)),
                                           options);
            for (const Text& text : texts) {
                if (text.text.contains(found)) {
                    wrong.append(QStringLiteral("%1: “%2” in “%3”").arg(text.file, word, text.text));
                }
            }
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
    }

    /// A factor has the sign ×, with no letter x in its place.
    void factorsHaveTheirSign() {
        static const QRegularExpression letter(
            QStringLiteral("(%\\d|\\d)\\s?x(\\s?(%\\d|\\d)|\\b)|\\bx%\\d"));
        QStringList wrong;
        for (const Text& text : interfaceTexts()) {
            if (text.text.contains(letter)) {
                wrong.append(text.file + QStringLiteral(": ") + text.text);
            }
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
    }
};

HITSCOPE_TEST(WordsTest, QCoreApplication)

}  // namespace hitscope::words_test

#include "words_test.moc"
