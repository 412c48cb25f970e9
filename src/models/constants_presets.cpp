// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/constants_presets.h"

#include <QCoreApplication>
#include <QSettings>
#include <algorithm>

#include "deform/dent_form_text.h"

namespace hitscope {

namespace {

QString translated(const char* words) {
    return QCoreApplication::translate("hitscope::ConstantsPresets", words);
}

ConstantsPreset ours(const char* name, const DeformationConstants& constants,
                     std::optional<DentForm> form = {}) {
    return {translated(name), constants, std::move(form), true};
}

/// As it is kept: nothing in it that has no effect, and no radius, which is each shot's.
DentForm kept(const DentForm& form) {
    DentForm own = plain(form);
    own.radius = 0.0f;
    return own;
}

QString key(std::size_t parameter) {
    return QString::fromUtf8(deformationParameters()[parameter].key);
}

QString text(std::string_view words) {
    return QString::fromUtf8(words.data(), static_cast<qsizetype>(words.size()));
}

void storeForm(QSettings& settings, const DentForm& form) {
    settings.setValue(QStringLiteral("profile"), text(keyOf(form.profile)));
    settings.setValue(QStringLiteral("direction"), text(keyOf(form.direction)));
    if (form.profile == DentProfile::Curve) {
        settings.setValue(QStringLiteral("curve"), text(curveText(form.curve, ' ')));
    }
}

/// Presets of before there were other forms have the paper's; nothing: what is there is no form.
std::optional<DentForm> loadForm(const QSettings& settings) {
    const auto word = [&settings](const QString& name, std::string_view usual) {
        return settings.value(name, text(usual)).toString().toStdString();
    };
    const DentForm usual;
    const auto profile = profileNamed(word(QStringLiteral("profile"), keyOf(usual.profile)));
    const auto direction = directionNamed(word(QStringLiteral("direction"), keyOf(usual.direction)));
    const auto curve = curveFrom(word(QStringLiteral("curve"), curveText(usual.curve, ' ')), ' ');
    if (!profile || !direction || !curve) {
        return std::nullopt;
    }
    DentForm form;
    form.profile = *profile;
    form.direction = *direction;
    form.curve = *curve;
    return form;
}

}  // namespace

bool ConstantsPreset::holdsFor(const DentForm& given) const {
    return !form || kept(given) == *form;
}

ConstantsPresets::ConstantsPresets()
    : m_presets{
          ours(QT_TRANSLATE_NOOP("hitscope::ConstantsPresets", "Paper"), {}, DentForm{}),
          ours(QT_TRANSLATE_NOOP("hitscope::ConstantsPresets", "Pinprick"), {0.15f, 0.006f, 0.1f}),
          ours(QT_TRANSLATE_NOOP("hitscope::ConstantsPresets", "Hammer"), {0.4f, 0.08f, 0.25f}),
          ours(QT_TRANSLATE_NOOP("hitscope::ConstantsPresets", "Deep and narrow"), {0.3f, 0.15f, 0.9f}),
          ours(QT_TRANSLATE_NOOP("hitscope::ConstantsPresets", "Wide and shallow"), {1.5f, 0.04f, 0.06f})} {}

std::optional<std::size_t> ConstantsPresets::find(const DeformationConstants& constants,
                                                  const DentForm& form) const {
    const auto found = std::find_if(m_presets.begin(), m_presets.end(), [&](const ConstantsPreset& preset) {
        return preset.constants == constants && preset.holdsFor(form);
    });
    return found == m_presets.end()
               ? std::nullopt
               : std::optional(static_cast<std::size_t>(std::distance(m_presets.begin(), found)));
}

Status ConstantsPresets::save(const QString& name, const DeformationConstants& constants,
                              const DentForm& form) {
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
        same->form = kept(form);
        return Done{};
    }
    const auto before = std::find_if(m_presets.begin(), m_presets.end(), [&](const ConstantsPreset& preset) {
        return !preset.isOurs && preset.name.localeAwareCompare(trimmed) > 0;
    });
    m_presets.insert(before, {trimmed, constants, kept(form), false});
    return Done{};
}

void ConstantsPresets::remove(const QString& name) {
    std::erase_if(m_presets,
                  [&name](const ConstantsPreset& preset) { return !preset.isOurs && preset.name == name; });
}

void ConstantsPresets::load(QSettings& settings) {
    std::erase_if(m_presets, [](const ConstantsPreset& preset) { return !preset.isOurs; });
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
        const std::optional<DentForm> form = loadForm(settings);
        if (isComplete && isValid(constants) && form) {
            // A name that is refused is not worth a message at start-up.
            static_cast<void>(save(settings.value(QStringLiteral("name")).toString(), constants, *form));
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
        storeForm(settings, preset.form.value_or(DentForm{}));
    }
    settings.endArray();
}

}  // namespace hitscope
