#include "widgets/dialogs/export/space_form.h"

#include "widgets/base/fields/number_field.h"
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <iterator>

namespace ramure {

SpaceForm::SpaceForm(QWidget* parent)
    : QWidget(parent)
    , m_up(new QComboBox(this))
    , m_unit(new QComboBox(this))
    , m_times(new QLabel(this))
    , m_scale(new NumberField(this))
{
    m_up->setObjectName(QStringLiteral("exportUp"));
    m_unit->setObjectName(QStringLiteral("exportUnit"));
    m_scale->setObjectName(QStringLiteral("exportScale"));
    m_up->addItems({QString(), QString()});
    for (std::size_t i = 0; i < std::size(lengthUnits); ++i)
        m_unit->addItem(QString());
    m_times->setBuddy(m_scale);
    m_scale->setRange(FileSpace::leastScale, FileSpace::mostScale);
    m_scale->setDefault(1.0);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    row->addWidget(m_up);
    row->addWidget(m_unit);
    row->addSpacing(8);
    row->addWidget(m_times);
    row->addWidget(m_scale);
    row->addStretch(1);
    connect(m_up, &QComboBox::currentIndexChanged, this, &SpaceForm::changed);
    connect(m_unit, &QComboBox::currentIndexChanged, this, &SpaceForm::changed);
    connect(m_scale, &NumberField::valueEdited, this, [this](double value) {
        m_scale->setValue(value);
        emit changed();
    });
    setFocusProxy(m_up);
    retranslate();
    setSpace({});
}

void SpaceForm::setSpace(const FileSpace& space)
{
    m_up->setCurrentIndex(static_cast<int>(space.up));
    m_unit->setCurrentIndex(static_cast<int>(space.unit));
    m_scale->setValue(space.scale);
    emit changed();
}

FileSpace SpaceForm::space() const
{
    return {static_cast<UpAxis>(m_up->currentIndex()), static_cast<std::size_t>(m_unit->currentIndex()),
            m_scale->value().value_or(1.0)};
}

void SpaceForm::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

void SpaceForm::retranslate()
{
    m_up->setItemText(static_cast<int>(UpAxis::Y), tr("Y up"));
    m_up->setItemText(static_cast<int>(UpAxis::Z), tr("Z up"));
    m_up->setToolTip(
        tr("The axis of the file that points up: Y for most game engines and Maya, Z for Blender, "
           "3ds Max and printers"));
    m_up->setAccessibleName(tr("Axis that points up"));
    const QString names[] = {tr("metres"),     tr("centimetres"), tr("millimetres"),
                             tr("kilometres"), tr("inches"),      tr("feet")};
    static_assert(std::size(names) == std::size(lengthUnits));
    for (std::size_t i = 0; i < std::size(lengthUnits); ++i)
        m_unit->setItemText(static_cast<int>(i), names[i]);
    m_unit->setToolTip(tr("What a 1 in the file is"));
    m_unit->setAccessibleName(tr("Unit"));
    m_times->setText(tr("Scale"));
    m_scale->setToolTip(tr("How many times larger than in the scene"));
    m_scale->setAccessibleName(tr("Scale"));
}

} // namespace ramure
