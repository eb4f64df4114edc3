#include "widgets/dialogs/export/kept_form.h"

#include "widgets/base/named.h"
#include "widgets/base/theme/preferences.h"
#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>

namespace ramure {

/// Before the names that users gave: nothing chosen, and the last export of this use.
enum KeptEntry { OwnRow, LastRow };

KeptForm::KeptForm(Preferences* preferences, std::function<QVariantMap()> settings, QWidget* parent)
    : QWidget(parent)
    , m_preferences(preferences)
    , m_settings(std::move(settings))
    , m_names(named(new QComboBox(this), "exportKept"))
    , m_keep(named(new QPushButton(tr("Keep"), this), "exportKeep"))
    , m_forget(named(new QPushButton(tr("Forget"), this), "exportForget"))
{
    m_names->setAccessibleName(tr("Settings"));
    m_names->setEditable(true);
    m_names->setInsertPolicy(QComboBox::NoInsert);
    m_names->lineEdit()->setMaxLength(60);
    m_names->lineEdit()->setPlaceholderText(tr("kept settings, or a name for these"));
    m_names->setToolTip(tr("Settings of this page under a name, or those of its last export. The folder of "
                           "the files is not part of them."));
    auto* row = layoutOf<QHBoxLayout>(this, 8);
    row->addWidget(m_names, 1);
    for (QPushButton* button : {m_keep, m_forget}) {
        button->setAutoDefault(false);
        row->addWidget(button);
    }
    connect(m_names, &QComboBox::activated, this, &KeptForm::take);
    connect(m_names->lineEdit(), &QLineEdit::textEdited, this, &KeptForm::update);
    connect(m_keep, &QPushButton::clicked, this, &KeptForm::keep);
    connect(m_forget, &QPushButton::clicked, this, &KeptForm::forget);
    fill();
}

void KeptForm::setUse(ExportUse use)
{
    m_use = use;
    fill();
}

QVariantMap KeptForm::kept(const QString& group, ExportUse use) const
{
    return m_preferences->exportSettings().value(group + u'/' + keyOf(use)).toMap();
}

void KeptForm::store(const QString& group, ExportUse use, const QVariantMap& settings)
{
    QVariantMap all = m_preferences->exportSettings();
    all.insert(group + u'/' + keyOf(use), settings);
    m_preferences->setExportSettings(all);
}

void KeptForm::fill()
{
    const QSignalBlocker quiet(m_names);
    m_names->clear();
    m_names->addItem(QString());
    m_names->addItem(tr("As the last time"));
    m_names->addItems(kept(namedKey, m_use).keys());
    m_names->setCurrentIndex(OwnRow);
    update();
}

void KeptForm::update()
{
    const QString name = m_names->currentText().trimmed();
    const bool isNamed = kept(namedKey, m_use).contains(name);
    m_keep->setEnabled(!name.isEmpty() && name != m_names->itemText(LastRow));
    m_forget->setEnabled(isNamed);
    m_keep->setToolTip(m_keep->isEnabled()
                           ? tr("Keeps the choices of this page under this name")
                           : tr("Type a name first; the choices of this page are kept under it"));
    m_forget->setToolTip(isNamed ? tr("Forgets the settings of this name")
                                 : tr("No kept settings are chosen"));
}

void KeptForm::take(int row)
{
    const QVariantMap settings =
        row == LastRow ? lastExport() : kept(namedKey, m_use).value(m_names->itemText(row)).toMap();
    if (row == LastRow && settings.isEmpty())
        emit told(tr("Nothing was exported from this page yet."));
    else if (row != OwnRow)
        emit chosen(settings);
    m_names->setCurrentIndex(row);
    update();
}

void KeptForm::keep()
{
    const QString name = m_names->currentText().trimmed();
    QVariantMap named = kept(namedKey, m_use);
    named.insert(name, m_settings());
    store(namedKey, m_use, named);
    fill();
    m_names->setCurrentText(name);
    update();
    emit told(tr("Kept as “%1”.").arg(name));
}

void KeptForm::forget()
{
    QVariantMap named = kept(namedKey, m_use);
    named.remove(m_names->currentText().trimmed());
    store(namedKey, m_use, named);
    fill();
}

} // namespace ramure
