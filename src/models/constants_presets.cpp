// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/constants_presets.h"

#include <QCoreApplication>
#include <QSettings>
#include <algorithm>

namespace hitscope {

namespace {

QString translated(const char* words) {
    return QCoreApplication::translate("hitscope::ConstantsPresets", words);
}

ConstantsPreset ours(const char* name, const DeformationConstants& constants) {
    return {translated(name), constants, true};
}

QString key(std::size_t parameter) {
    return QString::fromUtf8(deformationParameters()[parameter].key);
}

}  // namespace

ConstantsPresets::ConstantsPresets()
    : m_presets{
          ours(QT_TRANSLATE_NOOP("hitscope::ConstantsPresets", "Paper"), {}),
          ours(QT_TRANSLATE_NOOP("hitscope::ConstantsPresets", "Pinprick"), {0.15f, 0.006f, 0.1f}),
          ours(QT_TRANSLATE_NOOP("hitscope::ConstantsPresets", "Hammer"), {0.4f, 0.08f, 0.25f}),
          ours(QT_TRANSLATE_NOOP("hitscope::ConstantsPresets", "Deep and narrow"), {0.3f, 0.15f, 0.9f}),
          ours(QT_TRANSLATE_NOOP("hitscope::ConstantsPresets", "Wide and shallow"), {1.5f, 0.04f, 0.06f})} {}

std::optional<std::size_t> ConstantsPresets::find(const DeformationConstants& constants) const {
    const auto found = std::find_if(m_presets.begin(), m_presets.end(), [&](const ConstantsPreset& preset) {
        return preset.constants == constants;
    });
    return found == m_presets.end()
               ? std::nullopt
               : std::optional(static_cast<std::size_t>(std::distance(m_presets.begin(), found)));
}

Status ConstantsPresets::save(const QString& name, const DeformationConstants& constants) {
    const QString trimmed = name.trimmed();
    if (trimmed.isEmpty()) {
        return Error{"A preset needs a name.", "", "Type one."};
    }
    const auto same = std::find_if(m_presets.begin(), m_presets.end(), [&](const ConstantsPreset& preset) {
        return preset.name.compare(trimmed, Qt::CaseInsensitive) == 0;
    });
    if (same != m_presets.end() && same->isOurs) {
        return Error{"A preset of this name comes with Hitscope.", trimmed.toStdString(),
                     "Choose another name."};
    }
    if (same != m_presets.end()) {
        same->constants = constants;
        return Done{};
    }
    const auto before = std::find_if(m_presets.begin(), m_presets.end(), [&](const ConstantsPreset& preset) {
        return !preset.isOurs && preset.name.localeAwareCompare(trimmed) > 0;
    });
    m_presets.insert(before, {trimmed, constants, false});
    return Done{};
}

void ConstantsPresets::remove(std::size_t index) {
    if (index < m_presets.size() && !m_presets[index].isOurs) {
        m_presets.erase(m_presets.begin() + static_cast<std::ptrdiff_t>(index));
    }
}

void ConstantsPresets::load(QSettings& settings) {
    const int count = settings.beginReadArray(QStringLiteral("constantsPresets"));
    for (int i = 0; i < count; ++i) {
        settings.setArrayIndex(i);
        DeformationConstants constants;
        bool isComplete = true;
        for (std::size_t parameter = 0; parameter < deformationParameters().size(); ++parameter) {
            bool isNumber = false;
            setParameterValue(constants, parameter, settings.value(key(parameter)).toDouble(&isNumber));
            isComplete = isComplete && isNumber;
        }
        if (isComplete && isValid(constants)) {
            // A name that is refused is not worth a message at start-up.
            static_cast<void>(save(settings.value(QStringLiteral("name")).toString(), constants));
        }
    }
    settings.endArray();
}

void ConstantsPresets::store(QSettings& settings) const {
    settings.remove(QStringLiteral("constantsPresets"));
    settings.beginWriteArray(QStringLiteral("constantsPresets"));
    int index = 0;
    for (const ConstantsPreset& preset : m_presets) {
        if (preset.isOurs) {
            continue;
        }
        settings.setArrayIndex(index++);
        settings.setValue(QStringLiteral("name"), preset.name);
        for (std::size_t parameter = 0; parameter < deformationParameters().size(); ++parameter) {
            settings.setValue(key(parameter),
                              QString::number(parameterValue(preset.constants, parameter), 'g', 9));
        }
    }
    settings.endArray();
}

}  // namespace hitscope
