#include "widgets/window/tool_strip.h"

#include "widgets/base/number_field.h"
#include "widgets/view/tools/hand_settings.h"
#include "widgets/view/view_settings.h"
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QToolBar>
#include <cmath>

namespace ramure {
namespace {

constexpr int iconSide = 18, stripHeight = 36, leastTip = 120;

QString words(const char* english)
{
    return QCoreApplication::translate("HandOptions", english);
}

} // namespace

ToolStrip::ToolStrip(ViewSettings* settings, QList<QAction*> tools, QToolBar* transforms, QWidget* parent)
    : QWidget(parent)
    , m_settings(settings->hand())
    , m_tools(std::move(tools))
    , m_transforms(transforms)
    , m_icon(new QLabel(this))
    , m_name(new QLabel(this))
    , m_tip(new QLabel(this))
{
    setObjectName(QStringLiteral("toolStrip"));
    setAttribute(Qt::WA_StyledBackground);
    setFixedHeight(stripHeight);
    m_name->setObjectName(QStringLiteral("partTitle"));
    m_tip->setObjectName(QStringLiteral("dim"));
    m_tip->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_tip->setTextFormat(Qt::PlainText);
    // What does not fit is scrolled to, by Tab say: the window keeps its width.
    auto* scroll = new QScrollArea(this);
    auto* content = new QWidget(scroll);
    m_row = new QHBoxLayout(content);
    m_row->setContentsMargins(10, 0, 10, 0);
    m_row->setSpacing(8);
    m_row->addWidget(m_icon);
    m_row->addWidget(m_name);
    m_row->addSpacing(6);
    m_row->addWidget(m_transforms);
    addNumbers();
    addFlags();
    addShapes();
    m_row->addWidget(m_tip, 1);
    scroll->setWidget(content);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->viewport()->setAutoFillBackground(false);
    content->setAutoFillBackground(false);
    auto* whole = new QHBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(scroll);
    for (const QAction* tool : m_tools) {
        connect(tool, &QAction::toggled, this, &ToolStrip::follow);
        connect(tool, &QAction::changed, this, &ToolStrip::follow);
    }
    connect(m_settings, &HandSettings::toolChanged, this, &ToolStrip::follow);
    connect(m_settings, &HandSettings::optionsChanged, this, &ToolStrip::takeValues);
    retranslate();
    takeValues();
}

void ToolStrip::add(const Option& option, const char* id)
{
    option.widget->setObjectName(QLatin1String(id));
    if (option.label) {
        option.label->setBuddy(option.widget);
        m_row->addWidget(option.label);
    }
    m_row->addWidget(option.widget);
    m_options.push_back(option);
}

void ToolStrip::addNumbers()
{
    const auto field = [this](double least, double most, double step, const NumberFormat& format) {
        auto* made = new NumberField(this);
        made->setFormat(format);
        made->setRange(least, most);
        made->setStep(step);
        made->setScale(NumberScale(least, most, step, format.whole));
        made->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
        m_numbers.push_back(made);
        return made;
    };
    for (const HandNumber& row : handNumbers()) {
        const NumberFormat format{ParamUnit::None, row.scale, QString::fromLatin1(row.suffix), row.decimals};
        NumberField* made = field(row.least, row.most, row.step, format);
        connect(made, &NumberField::valueEdited, this, [this, member = row.member](double value) {
            HandOptions options = m_settings->options();
            options.*member = value;
            m_settings->setOptions(options);
        });
        auto* label = new QLabel(this);
        made->addHandle(label);
        add({row.tools, made, label, row.label, row.tip}, row.id);
    }
    for (const HandCount& row : handCounts()) {
        NumberField* made = field(row.least, row.most, 1.0, {ParamUnit::None, 1.0, QString(), 0, true});
        connect(made, &NumberField::valueEdited, this, [this, member = row.member](double value) {
            HandOptions options = m_settings->options();
            options.*member = int(std::lround(value));
            m_settings->setOptions(options);
        });
        auto* label = new QLabel(this);
        made->addHandle(label);
        add({row.tools, made, label, row.label, row.tip}, row.id);
    }
}

void ToolStrip::addFlags()
{
    for (const HandFlag& row : handFlags()) {
        auto* box = new QCheckBox(this);
        box->setFocusPolicy(Qt::TabFocus); // a click leaves the keys with the view
        connect(box, &QCheckBox::toggled, this, [this, member = row.member](bool on) {
            HandOptions options = m_settings->options();
            options.*member = on;
            m_settings->setOptions(options);
        });
        add({row.tools, box, nullptr, row.label, row.tip}, row.id);
    }
}

void ToolStrip::addShapes()
{
    m_shape = new QComboBox(this);
    m_shape->addItems({QString(), QString(), QString()});
    m_shape->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_shape->setFocusPolicy(Qt::TabFocus);
    connect(m_shape, &QComboBox::activated, this, [this](int index) {
        HandOptions options = m_settings->options();
        options.shape = static_cast<EditShapeKind>(index);
        m_settings->setOptions(options);
    });
    add({toolBit(HandTool::Prune), m_shape, new QLabel(this), QT_TRANSLATE_NOOP("HandOptions", "Shape"),
         QT_TRANSLATE_NOOP("HandOptions", "What stands out of it is cut")},
        "pruneShape");
}

void ToolStrip::takeValues()
{
    const HandOptions& options = m_settings->options();
    auto field = m_numbers.begin();
    for (const HandNumber& row : handNumbers())
        (*field++)->setValue(options.*row.member);
    for (const HandCount& row : handCounts())
        (*field++)->setValue(options.*row.member);
    for (const HandFlag& row : handFlags())
        findChild<QCheckBox*>(QLatin1String(row.id))->setChecked(options.*row.member);
    m_shape->setCurrentIndex(int(options.shape));
}

void ToolStrip::follow()
{
    const auto chosen = std::ranges::find_if(m_tools, &QAction::isChecked);
    if (chosen == m_tools.end())
        return; // on the way from one to another
    const QAction* tool = *chosen;
    m_icon->setPixmap(tool->icon().pixmap(QSize(iconSide, iconSide), devicePixelRatioF()));
    m_name->setText(tool->text().remove(u'&'));
    m_tipText = tool->statusTip();
    m_transforms->setVisible(m_settings->tool() == HandTool::None);
    for (const Option& option : m_options) {
        const bool shown = option.tools & toolBit(m_settings->tool());
        option.widget->setVisible(shown);
        if (option.label)
            option.label->setVisible(shown);
    }
    m_row->activate();
    elide();
}

void ToolStrip::elide()
{
    const int room = m_tip->width();
    m_tip->setText(room < leastTip ? QString()
                                   : m_tip->fontMetrics().elidedText(m_tipText, Qt::ElideRight, room));
    m_tip->setToolTip(m_tip->text() == m_tipText ? QString() : m_tipText);
}

void ToolStrip::retranslate()
{
    for (const Option& option : m_options) {
        if (option.label)
            option.label->setText(words(option.text));
        else
            static_cast<QCheckBox*>(option.widget)->setText(words(option.text));
        option.widget->setToolTip(words(option.tip));
        option.widget->setAccessibleName(words(option.text));
    }
    m_shape->setItemText(int(EditShapeKind::Sphere), tr("Sphere"));
    m_shape->setItemText(int(EditShapeKind::Box), tr("Box"));
    m_shape->setItemText(int(EditShapeKind::Cone), tr("Cone"));
    follow();
}

void ToolStrip::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    elide();
}

void ToolStrip::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        follow();
}

} // namespace ramure
