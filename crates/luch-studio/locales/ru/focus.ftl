## Фокус
focus-distance = Расстояние { $distance }
focus-nothing = Здесь ничего нет
focus-blur = Размытие { $pixels } пикс.
focus-blur-if-on = Размытие { $pixels } пикс., если включить глубину поля
focus-closed = Резко всё: радиус объектива 0
notice-focus-is-set = Фокусное расстояние задано
notice-focus-without-depth-of-field = Глубина поля выключена, поэтому резко всё: включите её в «Параметрах сцены».
notice-focus-with-closed-lens = Радиус объектива 0, поэтому резко всё: откройте объектив в разделе «Объектив».
notice-nothing-to-focus = Здесь не на чем сфокусироваться
