## Перемещение манипулятором
tool-move = Сдвиг
tool-move-tip = Тяните стрелку, квадрат или середину; с Ctrl — по четвертям
tool-rotate = Поворот
tool-rotate-tip = Тяните кольцо; с Ctrl — по 15 градусов
tool-scale = Масштаб
tool-scale-tip = Тяните круг или ось; с Ctrl — по 10 процентов
gizmo-no-turn = Здесь нечего поворачивать
gizmo-no-scale = Здесь нечего масштабировать
mouse-handle = Тянуть манипулятор
mouse-handle-does = Сдвинуть, повернуть или изменить размер выделенного
mouse-handle-snap = С Ctrl — манипулятор
mouse-handle-snap-does = То же шагами 0,25, 15° или 10 %
key-escape-drag = Escape
key-escape-drag-does = Отменить перетаскивание
