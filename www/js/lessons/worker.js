// The worker of the lessons.

import { serveAnswers } from "../common/answering.js";
import { answer, know } from "./answers.js";

serveAnswers(answer, know);
