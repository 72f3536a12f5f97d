language-name = Русский

## Меню и команды
menu-file = Файл
menu-edit = Правка
menu-view = Вид
menu-help = Справка
menu-theme = Оформление
menu-language = Язык / Language
theme-system = Как в системе
theme-light = Светлое
theme-dark = Тёмное
command-new = Новая сцена
command-save = Сохранить
command-quit = Выйти
command-undo = Отменить
command-redo = Повторить
command-duplicate = Дублировать
command-delete = Удалить
command-toggle-hidden = Скрыть или показать
command-select-nothing = Снять выделение
command-render = Визуализировать
command-cancel = Прервать
command-return-to-camera = Вернуться к камере
command-store-pose = Поставить камеру сюда
command-zoom-fit = Вписать изображение
command-zoom-one = Изображение 1:1

## Панели
panel-scene = Сцена
panel-objects = Список объектов сцены
panel-properties = Свойства объектов сцены
panel-parameters = Параметры сцены
panel-lens = Объектив
panel-resize = Ширина панели
scene-choice = Сцена
scene-choice-tip = Встроенные сцены; свои открываются через «Файл» или перетаскиванием в окно
scene-loading = Сцена загружается…
scene-two-spheres = Две сферы
scene-one-sphere = Одна сфера
scene-knight = Конь, куб и сфера
scene-chess = Шахматы
camera-choice = Камера
camera-choice-tip = Камеры сцены: выбрать, добавить, переименовать, удалить; звёздочка — вид сдвинут мышью
field-of-view = Поле зрения
field-of-view-tip = Вертикальный угол, который видит камера, в градусах
objects-filter = Найти по имени
objects-none = В сцене нет ни объектов, ни источников света
objects-none-found = С таким именем ничего нет
objects-hide = Скрыть: { $name }
objects-show = Показать: { $name }
properties-nothing = Щёлкните объект на изображении или в списке.
name = Имя
name-taken = Имя «{ $name }» занято
name-form = В имени должно быть от 1 до 256 байт и ни одного управляющего символа
color = Цвет
color-tip = Диффузный цвет поверхности: множитель при k_d cos θ
color-hue = Оттенок
color-shade = Насыщенность и яркость
reflection = Зеркальность
reflection-tip = Доля зеркала r: (1 − r)·свой свет + r·отражённый свет
gloss = Глянцевость
gloss-tip = Сила k_s и резкость n блика, k_s cosⁿ α: 0 % — матовая, 100 % — узкий яркий блик
checker = Клетки второго цвета
checker-tip = На стенах квадраты, на остальном кубы, чередуются с основным цветом
checker-color = Второй цвет
checker-size = Сторона клетки
shading-own = Закраска объекта
shading-of-scene = Как у сцены
position = Положение
rotation = Поворот
radius = Радиус
sides = Стороны
scale = Масштаб
normal = Нормаль
wall-bounded = Ограниченная
wall-bounded-tip = Прямоугольник вместо бесконечной плоскости
wall-width = Ширина
wall-height = Высота
mesh-facts = Треугольников: { $triangles }, файл { $path }
intensity = Интенсивность
light-color-tip = Цвет света: множитель при I_l
light-intensity = Интенсивность света
no-lights = В сцене нет источников света
antialiasing = Сглаживание
antialiasing-tip = Лучи, разбросанные по пикселю, сглаживают края
rays-per-pixel = Лучей на пиксель
depth-of-field = Глубина поля
depth-of-field-tip = Лучи разбросаны по объективу: резко лишь то, что на фокусном расстоянии
rays-over-the-lens = Лучей на объектив
shading = Закраска
shading-tip = Как освещаются сетки: по граням, по вершинам со смешением или со смешением нормалей
shading-flat = Плоская
shading-gouraud = По методу Гуро
shading-phong = По методу Фонга
ambient = Рассеянный свет
ambient-tip = I_a, свет, который есть везде, и в тени тоже
attenuation = Затухание K
attenuation-tip = Расстояние, на котором свет слабеет вдвое: его множитель K / (d + K)
background = Фон
background-tip = Цвет там, где ничего нет
focal-distance = Фокусное расстояние
focal-distance-tip = Расстояние вдоль взгляда, на котором резко, в единицах сцены
lens-radius = Радиус объектива
lens-radius-tip = Насколько объектив открыт: 0 — точечное отверстие, резко всё
picture-size = Размер изображения
picture-size-tip = Ширина и высота в пикселях
picture-width = Ширина изображения
picture-height = Высота изображения
depth = Глубина
depth-tip = Сколько поверхностей может встретить луч: дальше зеркало показывает фон
threads = Потоки
threads-tip = Сколько потоков работает одновременно; ядер у этой машины: { $cores }
live-update = Обновлять сразу
live-update-tip = Каждое изменение само начинает новое изображение; иначе изменения ждут кнопки
render-tip = Начать изображение заново, со всеми изменениями
progress = Ход работы
changes-wait = Изменения ждут кнопки
progress-preparing = Сцена готовится…
progress-left = { $percent }, осталось { $left }
milliseconds = { $n } мс
seconds = { $n } с
minutes = { $minutes } мин { $seconds } с
status-size = { $width } × { $height }
status-rays = { $rays ->
    [one] { $rays } луч на пиксель
    [few] { $rays } луча на пиксель
   *[other] { $rays } лучей на пиксель
}
status-threads = { $threads ->
    [one] { $threads } поток
    [few] { $threads } потока
   *[other] { $threads } потоков
}
status-speed = { $speed } млн лучей/с

## Изображение
picture = Изображение
picture-of = { $scene }, { $camera }
picture-with-selection = { $scene }, { $camera }; выделено: { $selected }
tool-select = Выделение
tool-select-tip = Щелчок выделяет объект, перетаскивание поворачивает вид
tool-focus = Фокус
tool-focus-tip = Щёлкните то, что должно быть резким: его расстояние станет фокусным
zoom-fit = Вписать
zoom-fit-tip = Показать изображение целиком
zoom-one = 1:1
zoom-one-tip = Показать пиксель изображения одним пикселем экрана

## Неверный ввод
input-empty = Не хватает числа
input-no-number = «{ $text }» — не число
input-no-whole-number = «{ $text }» — не целое число
input-out-of-range = Допустимо от { $low } до { $high }
input-no-color = «{ $text }» — не цвет вида #c83232

## Уведомления
notice-dismiss = Убрать
notice-not-loaded = Сцена не загружена
notice-loaded-with-warnings = Сцена загружена, но есть замечания
notice-saved = Сцена сохранена
notice-not-saved = Сцена не сохранена
notice-edit-refused = Изменение отклонено
notice-render-failed = Изображение не получилось; прежнее, если оно было, остаётся
notice-internal = Внутренняя ошибка программы; ваша сцена цела
new-scene-name = Новая сцена
new-lamp-name = Лампа

## Диалоги
dialog-close = Закрыть
dialog-about = О программе «Луч»
dialog-shortcuts = Клавиши и мышь
about-what = Студия трассировки лучей: правдивые изображения и объяснение, почему они такие.
about-version = Версия
about-simd = Набор команд
about-cores = Ядра
about-triangles = Треугольников в сцене
about-license = Лицензия
about-bits = Одна и та же сцена даёт одни и те же биты при каждом запуске и любом числе потоков.
shortcuts-mouse = Мышь на изображении
shortcuts-keys = Клавиши
mouse-click = Щелчок
mouse-click-does = Выделить объект или лампу; мимо — снять выделение
mouse-drag = Перетаскивание
mouse-drag-does = Осмотреть со всех сторон выделенное или то, что под указателем
mouse-pan = Правой кнопкой или с Shift
mouse-pan-does = Сдвинуть камеру вбок
mouse-wheel = Колесо
mouse-wheel-does = Приблизить камеру к тому, что под указателем, или отдалить
mouse-zoom = Ctrl и колесо
mouse-zoom-does = Изменить масштаб изображения
mouse-pan-pixels = Средней кнопкой
mouse-pan-pixels-does = Сдвинуть увеличенное изображение
