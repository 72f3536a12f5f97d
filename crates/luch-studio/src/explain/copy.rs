//! Writes accounts out for the clipboard, on a thread: those of many rays take their time.

use super::Explained;
use super::command::Format;
use super::panel::words_of;
use crate::l10n::Language;
use luch_explain::{Options, Samples, plain};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, sync_channel};
use std::thread;

/// What is being written.
#[derive(Debug, Default)]
pub(crate) struct Copier {
    running: Option<Receiver<String>>,
}

impl Copier {
    /// Accounts of more rays are no text for a clipboard: their JSON has hundreds of bytes a ray.
    pub(crate) const MOST_RAYS: usize = 100_000;

    /// Starts to write; `wake` is called when [`Copier::poll`] has something to answer. Text, Markdown and LaTeX tell
    /// of one sample ray by ray, JSON of all.
    ///
    /// # Errors
    /// If the system gives no thread.
    pub(crate) fn start(
        &mut self,
        answer: &Arc<Explained>,
        sample: u32,
        format: Format,
        language: Language,
        wake: impl FnOnce() + Send + 'static,
    ) -> std::io::Result<()> {
        let (send, receive) = sync_channel(1);
        let answer = Arc::clone(answer);
        thread::Builder::new().name("luch-copy".into()).spawn(move || {
            let options = Options { language: words_of(language), samples: Samples::One(sample), boxes: false };
            // Whoever asked may be gone, or have asked for something else.
            let _ = send.send(write(&answer, format, &options));
            wake();
        })?;
        self.running = Some(receive);
        Ok(())
    }

    pub(crate) const fn is_busy(&self) -> bool {
        self.running.is_some()
    }

    /// What was written, once.
    pub(crate) fn poll(&mut self) -> Option<String> {
        let text = self.running.as_ref()?.try_recv().ok()?;
        self.running = None;
        Some(text)
    }
}

fn write(answer: &Explained, format: Format, options: &Options) -> String {
    let explanation = answer.explanation();
    match format {
        Format::Text => explanation.text(options, &plain),
        Format::Markdown => explanation.markdown(options),
        Format::Latex => explanation.latex(options),
        Format::Json => {
            let mut bytes = Vec::new();
            // Memory takes all that is written to it.
            let _ = explanation.json(options, &mut bytes);
            String::from_utf8_lossy(&bytes).into_owned()
        }
    }
}
