// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/sweep_plan.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>

#include "cli/shoot.h"
#include "cli/sweep/sweep_keys.h"
#include "document/json_text.h"
#include "io/number_text.h"

namespace hitscope::cli {

namespace {

Error wrong(const QString& member, const QString& what) {
    return {what.toStdString(), member.toStdString(), ""};
}

/// As one would type it; empty: neither text nor number nor true.
QString valueText(const QJsonValue& value) {
    constexpr double kExactIntegers = 1.0e15;
    if (value.isString()) {
        return value.toString();
    }
    if (value.isBool()) {
        return value.toBool() ? QStringLiteral("true") : QString();
    }
    if (!value.isDouble()) {
        return {};
    }
    const double number = value.toDouble();
    if (number == std::floor(number) && std::abs(number) < kExactIntegers) {
        return QString::number(static_cast<qint64>(number));
    }
    std::string text;
    appendNumber(text, number);
    return QString::fromStdString(text);
}

/// An option with all its values.
struct SweptOption {
    QString name;
    QStringList values;
    bool isFile = false;
    bool isFlag = false;
};

/// Whether it says something about the shots, not about what becomes of them.
bool isSwept(const UsageOption& option) {
    return option.takes != UsageOption::Takes::Output && option.name != QLatin1String("json") &&
           option.name != QLatin1String("quiet");
}

Result<SweptOption> sweptOption(const QString& name, const QJsonValue& value, const Usage& shoot) {
    const QString member = QStringLiteral("options, ") + name;
    const UsageOption* option = shoot.find(name);
    if (option == nullptr || !isSwept(*option)) {
        return wrong(member, QStringLiteral("shoot has no such option that a sweep could take."));
    }
    SweptOption swept{
        name, {}, option->takes == UsageOption::Takes::File, option->takes == UsageOption::Takes::Nothing};
    for (const QJsonValue& each : value.isArray() ? value.toArray() : QJsonArray{value}) {
        const QString text = valueText(each);
        if (text.isEmpty() || swept.values.contains(text)) {
            return wrong(
                member,
                QStringLiteral("It has to be a text, a number or true, or a list of these, each once."));
        }
        swept.values << text;
    }
    return swept.values.isEmpty() ? Result<SweptOption>(wrong(member, QStringLiteral("The list is empty.")))
                                  : Result<SweptOption>(swept);
}

/// A key that is there twice, of which one would be lost; with its line.
Status checkKeys(std::string_view text, const JsonValue& object, const QString& within) {
    std::vector<JsonMember> members;
    if (Status read = object.members(members); !read) {
        return read;
    }
    for (auto member = members.begin(); member != members.end(); ++member) {
        const bool isTwice = std::any_of(members.begin(), member, [&member](const JsonMember& before) {
            return before.key == member->key;
        });
        if (isTwice) {
            return wrong(QStringLiteral("line %1, %2%3")
                             .arg(lineAt(text, member->value.offset()))
                             .arg(within, QString::fromUtf8(member->key)),
                         QStringLiteral("It is there twice."));
        }
        if (within.isEmpty() && isKey(member->key, "options") &&
            member->value.kind() == JsonValue::Kind::Object) {
            if (Status inner = checkKeys(text, member->value, QStringLiteral("options, ")); !inner) {
                return inner;
            }
        }
    }
    return Done{};
}

/// That no key is there twice, as Qt's reader takes the last of them.
Status checkKeys(const QByteArray& json) {
    const std::string_view text(json.constData(), static_cast<std::size_t>(json.size()));
    const Result<JsonValue> root = checkJson(text);
    return root ? checkKeys(text, root.value(), {}) : Status(root.error());
}

Result<QStringList> scenesOf(const QJsonValue& value) {
    QStringList scenes;
    for (const QJsonValue& each : value.toArray()) {
        if (!each.isString() || each.toString().isEmpty() || scenes.contains(each.toString())) {
            return wrong(QStringLiteral("scenes"),
                         QStringLiteral("It has to be a list of files, each once."));
        }
        scenes << each.toString();
    }
    if (!value.isUndefined() && (!value.isArray() || scenes.isEmpty())) {
        return wrong(QStringLiteral("scenes"), QStringLiteral("It has to be a list of files, each once."));
    }
    return scenes.isEmpty() ? QStringList{QString()} : scenes;
}

/// Combinations of scenes and options.
class Expansion {
public:
    Expansion(QString folder, const Usage& shoot, std::vector<SweptOption> options)
        : m_folder(std::move(folder)), m_shoot(shoot), m_options(std::move(options)) {}

    /// The first option turns slowest. `choice`: which value of each.
    Result<SweepJob> job(const QString& scene, const std::vector<qsizetype>& choice) {
        SweepJob job;
        job.scene = scene;
        job.arguments << QStringLiteral("shoot");
        QByteArray identity;
        for (std::size_t i = 0; i < m_options.size(); ++i) {
            const SweptOption& option = m_options[i];
            const QString& value = option.values[choice[i]];
            if (option.values.size() > 1) {
                job.values << value;
            }
            const QString given = option.isFile ? place(value) : value;
            job.arguments << (QStringLiteral("--") + option.name +
                              (option.isFlag ? QString() : u'=' + given));
            identity += option.name.toUtf8() + '=' +
                        (option.isFile ? m_keys.contentOf(given) : value.toUtf8()) + '\n';
            if (option.isFile && m_keys.contentOf(given).isEmpty()) {
                return wrong(given, QStringLiteral("There is no such file, or it cannot be read."));
            }
        }
        if (!scene.isEmpty()) {
            const QByteArray content = m_keys.sceneOf(place(scene));
            if (content.isEmpty()) {
                return wrong(place(scene), QStringLiteral("There is no such file, or it cannot be read."));
            }
            identity += content + (takesHits() ? QFileInfo(scene).completeBaseName().toUtf8() : QByteArray());
            job.arguments << place(scene);
        }
        Invocation given(m_shoot, job.arguments.mid(1));
        static_cast<void>(readShootOptions(given));
        if (!given.error().isEmpty()) {
            return wrong(QStringLiteral("options"), given.error());
        }
        constexpr int kDigits = 16;
        job.key = QString::fromLatin1(
            QCryptographicHash::hash(identity, QCryptographicHash::Sha256).toHex().left(kDigits));
        return job;
    }

    Result<SweepPlan> all(const QStringList& scenes) {
        SweepPlan plan;
        std::size_t count = static_cast<std::size_t>(scenes.size());
        for (const SweptOption& option : m_options) {
            if (option.values.size() > 1) {
                plan.axes << option.name;
            }
            count *= static_cast<std::size_t>(option.values.size());
            if (count > SweepPlan::kMostJobs) {
                return wrong(QStringLiteral("options"), QStringLiteral("That is more than 1,000,000 jobs."));
            }
        }
        for (const QString& scene : scenes) {
            std::vector<qsizetype> choice(m_options.size(), 0);
            do {
                Result<SweepJob> made = job(scene, choice);
                if (!made) {
                    return made.error();
                }
                plan.jobs.push_back(std::move(made).value());
            } while (next(choice));
        }
        return plan;
    }

private:
    [[nodiscard]] QString place(const QString& path) const {
        return QDir::cleanPath(QDir(m_folder).absoluteFilePath(path));
    }
    /// Hits of a file are on targets of a name, and a mesh may have that of its file.
    [[nodiscard]] bool takesHits() const {
        return std::any_of(m_options.begin(), m_options.end(),
                           [](const SweptOption& option) { return option.name == QLatin1String("hits"); });
    }
    /// Counts on, the last option first; false after the last combination.
    bool next(std::vector<qsizetype>& choice) const {
        for (std::size_t i = choice.size(); i-- > 0;) {
            if (++choice[i] < m_options[i].values.size()) {
                return true;
            }
            choice[i] = 0;
        }
        return false;
    }

    QString m_folder;
    const Usage& m_shoot;
    std::vector<SweptOption> m_options;
    SweepKeys m_keys;
};

QString quoted(QString argument) {
    static const QRegularExpression plain(QStringLiteral("^[A-Za-z0-9_./:=,+@%-]+$"));
    if (plain.match(argument).hasMatch()) {
        return argument;
    }
    return u'\'' + argument.replace(u'\'', QStringLiteral("'\\''")) + u'\'';
}

}  // namespace

Result<SweepPlan> readSweepPlan(const QByteArray& json, const QString& folder, const Usage& shoot) {
    QJsonParseError error{};
    const QJsonDocument document = QJsonDocument::fromJson(json, &error);
    if (!document.isObject()) {
        return wrong({}, QStringLiteral("A plan is a JSON object: %1.").arg(error.errorString()));
    }
    if (Status keys = checkKeys(json); !keys) {
        return keys.error();
    }
    const QJsonObject object = document.object();
    const QString version = QStringLiteral("hitscope-sweep");
    for (const QString& member : object.keys()) {
        if (member != version && member != QLatin1String("scenes") && member != QLatin1String("options")) {
            return wrong(member, QStringLiteral("A plan has no such member."));
        }
    }
    if (object[version].toDouble() != 1.0) {
        return wrong(version, QStringLiteral("It has to be 1."));
    }
    if (!object[QStringLiteral("options")].isObject()) {
        return wrong(QStringLiteral("options"), QStringLiteral("It has to be an object."));
    }
    const Result<QStringList> scenes = scenesOf(object[QStringLiteral("scenes")]);
    if (!scenes) {
        return scenes.error();
    }
    std::vector<SweptOption> options;
    const QJsonObject members = object[QStringLiteral("options")].toObject();
    for (auto member = members.begin(); member != members.end(); ++member) {
        Result<SweptOption> option = sweptOption(member.key(), member.value(), shoot);
        if (!option) {
            return option.error();
        }
        options.push_back(std::move(option).value());
    }
    return Expansion(folder, shoot, std::move(options)).all(scenes.value());
}

QStringList commandArguments(const SweepJob& job, const QString& reportPath) {
    return job.arguments + QStringList{QStringLiteral("--quiet"), QStringLiteral("--report=") + reportPath};
}

QString commandLine(const QString& program, const SweepJob& job, const QString& reportPath) {
    QStringList words{quoted(program)};
    for (const QString& argument : commandArguments(job, reportPath)) {
        words << quoted(argument);
    }
    return words.join(u' ');
}

}  // namespace hitscope::cli
