## The tool
tool-explain = Объяснение
tool-explain-tip = Щёлкните пиксель, чтобы узнать, откуда его цвет; стрелки переходят к соседним пикселям, с Shift через десять

## The panel
explain-pixel = Пиксель { $x }, { $y }
explain-pixel-tip = Столбец и строка, считая от 0 с левого верхнего угла. После щелчка по изображению стрелки переходят к соседним пикселям.
explain-close = Закрыть
explain-close-tip = Закрыть объяснение (Esc)
explain-every-digit = Все цифры
explain-every-digit-tip = Записывать числа так, чтобы они читались обратно бит в бит; иначе пятью цифрами, и суммы могут расходиться в последней
explain-working = Прослеживаем лучи…
explain-older = О прежнем изображении
explain-older-tip = Изображение с тех пор изменилось; объяснение обновится, когда будет готово новое
explain-other-view = Показан другой вид
explain-other-view-tip = Объясняется всегда освещённое изображение; для сравнения выберите его в меню «Вид»
explain-linear = Линейный
explain-linear-tip = Красный, зелёный и синий до кривой sRGB, до последней цифры: лучи ниже дают в сумме ровно это
explain-srgb = sRGB
explain-srgb-tip = То же после кривой sRGB в шагах по 1/255, как на экране и в файле PNG
explain-samples = { $samples ->
    [one] { $samples } выборка
    [few] { $samples } выборки
   *[other] { $samples } выборок
}
explain-samples-tip = Лучи через этот пиксель; его цвет — их среднее
explain-spread = разброс { $deviation }
explain-spread-tip = Стандартное отклонение выборок; самая тёмная { $min }, самая светлая { $max }
explain-outside = В изображении { $width } × { $height } такого пикселя больше нет. Щёлкните другой.
explain-too-many = У этого пикселя миллионы лучей, их не показать. Уменьшите число лучей на пиксель, глубину или число источников света.
explain-stopped = Остановлено.

## The tree
explain-height = Высота объяснения
explain-tree-width = Ширина дерева
explain-tree = Лучи пикселя
explain-unfold-all = Развернуть всё
explain-fold-all = Свернуть всё
explain-column-ray = Где кончается луч
explain-column-ray-tip = Луч, а под ним те, что он вызвал: по одному к каждому источнику света и зеркальный
explain-column-number = №
explain-column-number-tip = Номер, под которым луч назван в сумме и в скопированных текстах
explain-column-t = t
explain-column-t-tip = Сколько проходит луч, в единицах сцены
explain-column-share = Вес
explain-column-share-tip = Какая часть цвета луча доходит до пикселя
explain-sample-row = Выборка { $sample }: { $end }
explain-ends-nowhere = Пустота: цвет фона
explain-ends-depth = Глубина исчерпана: цвет фона
explain-ends-light = { $light }
explain-ends-blocked = { $light } за объектом «{ $blocker }»
explain-camera-ray = Луч камеры
explain-mirror-ray = Зеркальный луч
explain-lit-ray = Теневой луч, свободен
explain-blocked-ray = Теневой луч, заслонён

## What is told of a ray
explain-over-lights = видимые
explain-strength-tip = I_l: сила источника — K, умноженное на его интенсивность i
explain-contribution = Доля в пикселе
explain-contribution-tip = Вес луча, умноженный на его цвет: что в пикселе приходит по этому лучу

explain-facts-ray = Луч
explain-facts-surface = Поверхность
explain-facts-directions = Направления

## The pages
explain-page-sum = Сумма
explain-page-sum-tip = Сумма освещения выбранного луча с числами
explain-page-top = Вид сверху
explain-page-top-tip = Сцена сверху с лучами выборки
explain-page-boxes = Боксы
explain-page-boxes-tip = Боксы, в которые входит луч, и фигуры, которые с ним проверяются
explain-top-tip = Перетаскивание сдвигает, колесо меняет масштаб, двойной щелчок показывает всё. Клавиши: стрелки, плюс, минус, 0.
explain-walk-counts = Боксов пройдено: { $boxes }. Проверено: треугольников { $triangles }, других фигур { $shapes }.
explain-walk-tip = Путь этого луча в одиночку, ближние боксы первыми. Ядра, которые делают изображение, проходят боксы вместе с соседними лучами и находят то же самое.
explain-no-boxes = Этот луч не входит ни в один бокс.
explain-level = Уровень
explain-level-tip = Как глубоко лежат боксы, показанные на изображении: 0 — вокруг всей сцены
explain-outer-levels = и выше
explain-boxes-here = { $boxes ->
    [one] { $boxes } бокс
    [few] { $boxes } бокса
   *[other] { $boxes } боксов
}
explain-box-of-scene = сцена
explain-leaf = Лист: { $of }
explain-node = Бокс: { $of }
explain-triangle = { $object }, треугольник { $triangle }
explain-missed = мимо

## The clipboard
explain-copy = Копировать
explain-copy-tip = Скопировать объяснение, чтобы сдать его или работать с ним
explain-copy-text = Как текст
explain-copy-markdown = Как Markdown
explain-copy-latex = Как LaTeX
explain-copy-json = Как JSON
explain-copy-sample-tip = Формулы с числами, луч за лучом, для выбранной выборки
explain-copy-json-tip = Все лучи всех выборок со всеми цифрами, по схеме luch explain --json
explain-copy-too-many = Для буфера обмена лучей слишком много: luch explain --json пишет их в файл
explain-copied = Объяснение скопировано
