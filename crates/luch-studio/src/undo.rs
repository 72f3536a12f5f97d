//! Undo and redo: the inverses of the edits made, grouped by the gesture that made them.

use luch_scene::{Edit, EditError, Scene};
use std::mem::discriminant;

/// Whether an edit belongs to a gesture that is still going on, such as the drag of a slider.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Gesture {
    /// A change of its own: one step of undo.
    Single,
    /// Part of the gesture of this widget: one step together with those before it.
    Ongoing(egui::Id),
}

/// One step of undo: the edits that take it back, to be applied from the last to the first.
#[derive(Debug)]
struct Step {
    inverses: Vec<Edit>,
    gesture: Option<egui::Id>,
    /// Names the state of the scene after this step.
    state: u64,
}

/// What can be undone and redone.
#[derive(Debug, Default)]
pub(crate) struct History {
    undo: Vec<Step>,
    redo: Vec<Step>,
    states: u64,
    base: u64,
}

impl History {
    /// Applies an edit and remembers how to take it back.
    ///
    /// # Errors
    /// What the edit answers; scene and history are then as they were.
    pub(crate) fn apply(&mut self, edit: Edit, gesture: Gesture, scene: &mut Scene) -> Result<(), EditError> {
        let inverse = edit.apply(scene)?;
        self.redo.clear();
        self.states += 1;
        let gesture = match gesture {
            Gesture::Single => None,
            Gesture::Ongoing(id) => Some(id),
        };
        if let Some(step) = self.undo.last_mut()
            && gesture.is_some()
            && step.gesture == gesture
        {
            step.state = self.states;
            // The first inverse of a property already leads back to where the gesture began.
            if !step.inverses.iter().any(|known| same_property(known, &inverse)) {
                step.inverses.push(inverse);
            }
            return Ok(());
        }
        self.end_gesture();
        self.undo.push(Step { inverses: vec![inverse], gesture, state: self.states });
        Ok(())
    }

    /// Ends the gesture that is going on: the next edit is a step of its own.
    pub(crate) fn end_gesture(&mut self) {
        if let Some(step) = self.undo.last_mut() {
            step.gesture = None;
        }
    }

    /// Takes back the gesture that is going on, as if it had never been made: it cannot be redone. Answers whether there
    /// was one of that name.
    pub(crate) fn take_back(&mut self, gesture: egui::Id, scene: &mut Scene) -> Result<bool, EditError> {
        let Some(step) = self.undo.pop_if(|step| step.gesture == Some(gesture)) else { return Ok(false) };
        Edit::Group(step.inverses.into_iter().rev().collect()).apply(scene)?;
        Ok(true)
    }

    /// Takes the last step back; answers whether there was one.
    pub(crate) fn undo(&mut self, scene: &mut Scene) -> Result<bool, EditError> {
        self.end_gesture();
        Self::turn(&mut self.undo, &mut self.redo, scene)
    }

    /// Makes the last undone step again; answers whether there was one.
    pub(crate) fn redo(&mut self, scene: &mut Scene) -> Result<bool, EditError> {
        Self::turn(&mut self.redo, &mut self.undo, scene)
    }

    fn turn(from: &mut Vec<Step>, to: &mut Vec<Step>, scene: &mut Scene) -> Result<bool, EditError> {
        let Some(step) = from.pop() else { return Ok(false) };
        let edits = step.inverses.into_iter().rev().collect();
        let inverse = Edit::Group(edits).apply(scene)?;
        to.push(Step { inverses: vec![inverse], gesture: None, state: step.state });
        Ok(true)
    }

    pub(crate) fn can_undo(&self) -> bool {
        !self.undo.is_empty()
    }

    pub(crate) fn can_redo(&self) -> bool {
        !self.redo.is_empty()
    }

    /// A number that names the scene as it is: equal numbers, equal scenes.
    pub(crate) fn state(&self) -> u64 {
        self.undo.last().map_or(self.base, |step| step.state)
    }
}

/// Whether two edits set the same property of the same thing.
fn same_property(a: &Edit, b: &Edit) -> bool {
    match (a, b) {
        (Edit::Object(i, a), Edit::Object(j, b)) => i == j && discriminant(a) == discriminant(b),
        (Edit::Light(i, a), Edit::Light(j, b)) => i == j && discriminant(a) == discriminant(b),
        (Edit::Camera(i, a), Edit::Camera(j, b)) => i == j && discriminant(a) == discriminant(b),
        (Edit::Scene(a), Edit::Scene(b)) => discriminant(a) == discriminant(b),
        (Edit::Settings(a), Edit::Settings(b)) => discriminant(a) == discriminant(b),
        (Edit::Group(a), Edit::Group(b)) => a.len() == b.len() && a.iter().zip(b).all(|(a, b)| same_property(a, b)),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use luch_scene::{NonNegative, SceneEdit};

    fn ambient(value: f32) -> Edit {
        Edit::Scene(SceneEdit::SetAmbient(NonNegative::clamped(value)))
    }

    #[test]
    fn a_gesture_is_one_step() {
        let mut scene = Scene::new("s");
        let before = scene.clone();
        let mut history = History::default();
        let drag = Gesture::Ongoing(egui::Id::unique("slider"));
        for i in 0..100 {
            history.apply(ambient(i as f32), drag, &mut scene).unwrap();
        }
        history.end_gesture();
        history.apply(ambient(7.0), drag, &mut scene).unwrap();
        assert_eq!(history.undo.len(), 2);
        assert_eq!(history.undo[0].inverses.len(), 1);
        assert!(history.undo(&mut scene).unwrap());
        assert_eq!(scene.ambient.get(), 99.0);
        assert!(history.undo(&mut scene).unwrap());
        assert_eq!(scene, before);
        assert!(!history.undo(&mut scene).unwrap());
        assert!(history.redo(&mut scene).unwrap() && history.redo(&mut scene).unwrap());
        assert_eq!(scene.ambient.get(), 7.0);
    }

    #[test]
    fn the_state_names_the_scene() {
        let mut scene = Scene::new("s");
        let mut history = History::default();
        let start = history.state();
        history.apply(ambient(1.0), Gesture::Single, &mut scene).unwrap();
        let one = history.state();
        history.apply(ambient(2.0), Gesture::Single, &mut scene).unwrap();
        assert_ne!(one, history.state());
        history.undo(&mut scene).unwrap();
        assert_eq!(one, history.state());
        history.undo(&mut scene).unwrap();
        assert_eq!(start, history.state());
        history.apply(ambient(3.0), Gesture::Single, &mut scene).unwrap();
        assert!(![start, one].contains(&history.state()));
        assert!(!history.can_redo());
    }

    #[test]
    fn a_gesture_that_is_taken_back_leaves_nothing_behind() {
        let mut scene = Scene::new("s");
        let mut history = History::default();
        history.apply(ambient(1.0), Gesture::Single, &mut scene).unwrap();
        let (before, state) = (scene.clone(), history.state());
        let drag = egui::Id::unique("handle");
        for i in 0..10 {
            history.apply(ambient(i as f32), Gesture::Ongoing(drag), &mut scene).unwrap();
        }
        assert!(!history.take_back(egui::Id::unique("other"), &mut scene).unwrap());
        assert!(history.take_back(drag, &mut scene).unwrap());
        assert_eq!((&scene, history.state()), (&before, state));
        assert!(!history.can_redo() && !history.take_back(drag, &mut scene).unwrap());
        // One that has ended is a step like any other.
        history.apply(ambient(3.0), Gesture::Ongoing(drag), &mut scene).unwrap();
        history.end_gesture();
        assert!(!history.take_back(drag, &mut scene).unwrap());
    }

    #[test]
    fn a_refused_edit_leaves_no_step() {
        let mut scene = Scene::new("s");
        let mut history = History::default();
        assert!(history.apply(Edit::RemoveObject(3), Gesture::Single, &mut scene).is_err());
        assert!(!history.can_undo());
    }
}
